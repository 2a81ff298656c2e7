## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} trigonometric (@var{system}, @var{h}, @var{solver})
## Strang's splitting in coordinates and momenta, symplectic and symmetric, in steps of @var{h} (s), for
## @code{integrate_fixed}: half a step of what is not linear, by the implicit midpoint rule, a step of the linear
## oscillation, exactly, and half a step again (Deuflhard, Z. angew. Math. Phys. 30, 1979; Hairer, Lubich and Wanner,
## Geometric Numerical Integration, XIII).  Steps of k*pi/omega meet its resonances.
## @end deftypefn

function stepper = trigonometric (system, h, solver)
  momenta = system.momenta;
  flow = expm (h*momenta.linear);
  rest = @(t, z) momenta.rate (t, z) - momenta.linear*z;
  stepper = struct ("form", momenta.form, "state", momenta.state, "step", @(t, z) step (t, z, h, rest, flow));
endfunction

function [z, converged] = step (t, z, h, rest, flow)
  [z, first] = kicked (t + h/4, z, h/2, rest);
  [z, second] = kicked (t + 3*h/4, flow*z, h/2, rest);
  converged = first && second;
endfunction

function [z, converged] = kicked (t, z, h, rest)
  middle = z;
  for sweep = 1:30
    last = middle;
    middle = z + h/2*rest (t, middle);
    if (max (abs (middle - last)) <= 1e-14*max (abs (middle)))
      break;
    endif
  endfor
  converged = sweep < 30;
  z = 2*middle - z;
endfunction

%!test # a linear oscillation is exact
%! rate = @(t, z) [z(2); -9*z(1)];
%! system = struct ("momenta", struct ("rate", rate, "form", @(y) y, "state", @(z) z, "linear", [0 1; -9 0]));
%! z = trigonometric (system, 5, struct ()).step (0, [1; 0]);
%! assert (z, [cos(15); -3*sin(15)], 1e-12);
