## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} generalized_alpha (@var{system}, @var{h}, @var{solver})
## The generalized-alpha method (Chung and Hulbert, J. Appl. Mech. 60, 1993; for a mass matrix that varies: Arnold
## and Bruels, Multibody Syst. Dyn. 18, 2007) in steps of @var{h} (s), for @code{integrate_fixed}.  It damps what
## is far beyond the step to @var{solver}.rho_infinity (0 to 1) in a step.  Newton's iteration takes the matrices
## of the linear oscillation.
## @end deftypefn

function stepper = generalized_alpha (system, h, solver)
  c = alpha_coefficients (solver.rho_infinity);
  c.h = h;
  c.n = rows (system.mass);
  effective = system.mass + c.part*c.beta*h^2*system.stiffness;
  if (isfield (system, "damping_matrix"))
    effective += c.part*c.gamma*h*system.damping_matrix;
  endif
  c.iteration = effective \ system.mass;
  form = system.accelerations;
  rate = form.rate;
  stepper.form = @(y) begun (form.form (y), c.n);
  stepper.state = @(z) form.state (z(1:end-2*c.n));
  stepper.step = @(t, z) step (t, z, c, rate);
endfunction

## z: coordinates, rates, the rest; then the auxiliary accelerations a and the accelerations, not known at first
function z = begun (z, n)
  z = [z; NaN(2*n, 1)];
endfunction

function [z, converged] = step (t, z, c, rate)
  n = c.n;
  h = c.h;
  x = z(1:n);
  v = z(n+1:2*n);
  rest = z(2*n+1:end-2*n);
  a = z(end-2*n+1:end-n);
  v_dot = z(end-n+1:end);
  now = rate (t, [x; v; rest]);
  if (any (isnan (a)))
    a = v_dot = now(n+1:2*n);
  endif
  next = v_dot;
  last = Inf;
  for sweep = 1:30
    [new_x, new_v, new_a] = alpha_update (c, h, x, v, a, v_dot, next);
    there = rate (t + h, [new_x; new_v; rest]);
    change = c.iteration*(there(n+1:2*n) - next);
    next += change;
    size = max ([0; abs(change)/max([abs(next); realmin])]);  # a rigid rod in a hub has no coordinates
    if (size <= 1e-12 || (size <= 1e-9 && size >= last))  # as near as rounding lets it
      break;
    elseif (sweep > 3 && ! (size < 1))  # it diverges
      sweep = 30;
      break;
    endif
    last = size;
  endfor
  converged = sweep < 30;
  rest += h/2*(now(2*n+1:end) + there(2*n+1:end));
  z = [new_x; new_v; rest; new_a; next];
endfunction

%!test # far beyond the step an oscillation is damped to rho_infinity in a step
%! system = struct ("mass", 1, "stiffness", 1e12, "accelerations", ...
%!                  struct ("rate", @(t, z) [z(2); -1e12*z(1)], "form", @(y) y, "state", @(z) z));
%! for rho = [0.3 0.8 1]
%!   stepper = generalized_alpha (system, 1, struct ("rho_infinity", rho));
%!   z = stepper.form ([1; 0]);
%!   for k = 1:40
%!     z = stepper.step (0, z);
%!     size(k) = norm (z(3));
%!   endfor
%!   assert ((size(40)/size(20))^(1/20), rho, 0.1);
%! endfor
%!test # without coordinates, as a rigid rod in a hub, what only follows is integrated by the trapezoidal rule
%! system = struct ("mass", zeros (0), "stiffness", zeros (0), "accelerations", ...
%!                  struct ("rate", @(t, z) [t; 1], "form", @(y) y, "state", @(z) z));
%! stepper = generalized_alpha (system, 0.5, struct ("rho_infinity", 0.8));
%! [z, converged] = stepper.step (1, stepper.form ([2; 3]));
%! assert (converged); assert (z, [2 + 0.5*1.25; 3.5], 1e-15);
%!test # damping: m x'' + d x' + k x = 0 from x = 1, to the order two in steps of 0.01
%! system = struct ("mass", 2, "stiffness", 8, "damping_matrix", 3, "accelerations", ...
%!                  struct ("rate", @(t, z) [z(2); -(3*z(2) + 8*z(1))/2], "form", @(y) y, "state", @(z) z));
%! stepper = generalized_alpha (system, 0.01, struct ("rho_infinity", 0.8));
%! z = stepper.form ([1; 0]);
%! for k = 1:100
%!   [z, converged] = stepper.step (0, z);
%!   assert (converged);
%! endfor
%! omega = sqrt (4 - 0.75^2);
%! assert (z(1), exp (-0.75)*(cos (omega) + 0.75/omega*sin (omega)), 1e-4);
