## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} rk4 (@var{system}, @var{h}, @var{solver})
## The classical Runge-Kutta method of order 4 (Kutta, 1901) in steps of @var{h} (s), for @code{integrate_fixed}.
## @end deftypefn

function stepper = rk4 (system, h, solver)
  stepper = struct ("form", @(y) y, "state", @(y) y, "step", @(t, y) step (t, y, h, system.rate));
endfunction

function [y, converged] = step (t, y, h, rate)
  k1 = rate (t, y);
  k2 = rate (t + h/2, y + h/2*k1);
  k3 = rate (t + h/2, y + h/2*k2);
  k4 = rate (t + h, y + h*k3);
  y += h/6*(k1 + 2*k2 + 2*k3 + k4);
  converged = true;
endfunction

%!test # exact for a load of degree 3
%! stepper = rk4 (struct ("rate", @(t, y) 4*t^3), 0.5, struct ());
%! assert (stepper.step (0.5, 1), 1 + 1 - 0.5^4, 1e-14);
%!test # an oscillator: Taylor's polynomial of degree 4
%! stepper = rk4 (struct ("rate", @(t, y) [y(2); -y(1)]), 0.5, struct ());
%! assert (stepper.step (0, [1; 0]), [1 - 0.5^2/2 + 0.5^4/24; -0.5 + 0.5^3/6], 1e-15);
