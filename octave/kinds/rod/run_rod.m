## -*- texinfo -*-
## @deftypefn {} {@var{run} =} run_rod (@var{scene}, @var{model}, @var{method}, @var{tolerance})
## The motion of a checked scene's rod as this @var{model} (see @code{build_model}) has it, by an integrator's
## @var{method} with this @var{tolerance} (m): a struct of model, history (see @code{measure}), count (see
## @code{integrate}) and the centreline at the frame times (x, y: 21 stations by frames, m).  A run that leaves its
## energy balance is an error.
## @end deftypefn

function run = run_rod (scene, model, method, tolerance)
  times = frame_times (scene);
  system = rod_system (scene, model);
  solver = setfield (setfield (scene.solver, "name", method), "tolerance", tolerance);
  [states, count] = integrate (system, times, solver);
  history = measure (system, model, times, states);
  watch_balance (history, system, count);
  run = struct ("model", model, "history", history, "count", count);
  [run.x, run.y] = centreline (model, linspace (0, model.length, 21), history, 1);
endfunction

%!test # the rigid rod
%! scene = check_scene (setfield (paper (), "model", "modes", [0 0]));
%! run = run_rod (scene, build_model (scene, rung_of_scene (scene)), "ode45", 1e-6);
%! assert (size (run.x), [21 91]); assert (run.count.method, "ode45");
%! assert (hypot (run.x(end,:), run.y(end,:)), ones (1, 91), 1e-12);
