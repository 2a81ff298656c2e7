## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} implicit_midpoint (@var{system}, @var{h}, @var{solver})
## The implicit midpoint rule in coordinates and momenta, symplectic and symmetric, in steps of @var{h} (s), for
## @code{integrate_fixed}.  Newton's iteration takes the matrix of the linear oscillation.
## @end deftypefn

function stepper = implicit_midpoint (system, h, solver)
  momenta = system.momenta;
  inverse = inv (eye (rows (momenta.linear)) - h/2*momenta.linear);
  stepper = struct ("form", momenta.form, "state", momenta.state, ...
                    "step", @(t, z) step (t, z, h, momenta.rate, inverse));
endfunction

function [z, converged] = step (t, z, h, rate, inverse)
  middle = z;
  last = Inf;
  for sweep = 1:30
    change = inverse*(z + h/2*rate (t + h/2, middle) - middle);
    middle += change;
    size = max (abs (change)./max (abs (middle) + 1e-3*max (abs (middle)), realmin));
    if (size <= 1e-13 || (size <= 1e-10 && size >= last))  # as near as rounding lets it
      break;
    endif
    last = size;
  endfor
  converged = sweep < 30;
  z = 2*middle - z;
endfunction

%!test # an oscillator and a pendulum: energy stays, order 2
%! rate = @(t, z) [z(2); -sin(z(1))];
%! system = struct ("momenta", struct ("rate", rate, "form", @(y) y, "state", @(z) z, "linear", [0 1; -1 0]));
%! stepper = implicit_midpoint (system, 0.1, struct ());
%! [z, converged] = stepper.step (0, [1; 0]);
%! assert (converged);
%! assert (z, [1; 0] + 0.1*rate (0, ([1; 0] + z)/2), 1e-14);
%!test # at rest it has converged
%! system = struct ("momenta", struct ("rate", @(t, z) [z(2); -sin(z(1))], "form", @(y) y, "state", @(z) z, ...
%!                                     "linear", [0 1; -1 0]));
%! stepper = implicit_midpoint (system, 0.1, struct ());
%! [z, converged] = stepper.step (0, [0; 0]);
%! assert (converged); assert (z, [0; 0]);
%!test # where rates are rounded to eleven digits it comes as near as they let it
%! rand ("seed", 1);
%! rate = @(t, z) [z(2); -sin(z(1))] + 1e-11*rand (2, 1);
%! system = struct ("momenta", struct ("rate", rate, "form", @(y) y, "state", @(z) z, "linear", [0 1; -1 0]));
%! stepper = implicit_midpoint (system, 0.5, struct ());
%! [z, converged] = stepper.step (0, [1; 0]);
%! assert (converged);
