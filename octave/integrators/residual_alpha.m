## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} residual_alpha (@var{system}, @var{h}, @var{solver})
## The generalized-alpha method (see @code{generalized_alpha}) of a rod on a surface (see @code{surface_rod}) in steps
## of @var{h} (s), for @code{integrate_fixed}: Newton's iteration on the residual at the step's end takes the mass, the
## stiffness and the damping where it begins.
## @end deftypefn

function stepper = residual_alpha (system, h, solver)
  c = alpha_coefficients (solver.rho_infinity);
  n = system.n;
  stepper.form = @(y) [y; NaN(2*n, 1)];
  stepper.state = @(z) z(1:end-2*n);
  stepper.step = @(t, z) step (t, z, c, h, system);
endfunction

## z: coordinates, rates, W, D; then the auxiliary accelerations a and the accelerations, not known at first
function [z, converged] = step (t, z, c, h, system)
  n = system.n;
  [x, v, rest, a, v_dot] = mat2cell (z, [n, n, 2, n, n]){:};
  if (any (isnan (a)))
    a = v_dot = -(system.mass_matrix (x) \ system.residual (t, x, v, 0*x));
  endif
  tangent = system.mass_matrix (x) + c.part*c.beta*h^2*system.tangent_stiffness (t, x, v, v_dot);
  if (system.damped)
    tangent += c.part*c.gamma*h*system.tangent_damping (t, x, v, v_dot);
  endif
  next = v_dot;
  last = Inf;
  for sweep = 1:30
    [new_x, new_v, new_a] = alpha_update (c, h, x, v, a, v_dot, next);
    change = tangent \ system.residual (t + h, new_x, new_v, next);
    next -= change;
    size = h^2*c.beta*system.size (change)/system.points(end);
    converged = size <= 1e-13 || (size <= 1e-11 && size >= last);  # as near as rounding lets it
    if (converged || ! (size < 1))
      break;
    endif
    last = size;
  endfor
  rest += h/2*(system.power (t, x, v, v_dot) + system.power (t + h, new_x, new_v, next));
  z = [new_x; new_v; rest; new_a; next];
endfunction

%!function [run, scene] = swing_by (step, rho)
%!  scene = large_swing ();
%!  scene.duration = 0.2; scene.frames_per_second = 20; scene.model.modes = [5 5];
%!  scene.rod.damping = 1e-3;
%!  scene.solver = struct ("name", "generalized_alpha", "step", step, "rho_infinity", rho, "tolerance", 1e-4);
%!  scene = check_surface_scene (scene);
%!  run = run_model (surface_kind (), scene, surface_rod (scene));
%!endfunction
%!test # half the step, a quarter of the error, against radau; work and what dissipates, too
%! [~, scene] = swing_by (0.01, 1);
%! scene.solver = struct ("name", "radau", "tolerance", 1e-9);
%! reference = run_model (surface_kind (), scene, surface_rod (scene));
%! off = @(run) [distance(run, reference), abs(run.history.D(end) - reference.history.D(end))];
%! ratio = off (swing_by (5e-4, 0.8))./off (swing_by (2.5e-4, 0.8));
%! assert (ratio, [4 4], 1.2);
