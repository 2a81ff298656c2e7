## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} exact_rod (@var{scene}, @var{modes}, @var{seconds})
## The top rung of the ladder of models: the geometrically exact rod (see @code{exact_scene}) of a checked scene, in
## [@var{modes} @var{modes}] polynomials.  A struct of x and y (21-by-m, m), the centreline at the frame times, and
## count; empty where it has not what the scene has.  What takes more than so many @var{seconds} (default: any) is
## given up: an error.
## @end deftypefn

function trial = exact_rod (scene, modes, seconds = Inf)
  trial = [];
  plane = exact_scene (scene);
  if (isempty (plane))
    return;
  endif
  plane.model.modes = [modes modes];
  plane.solver.name = "auto";
  plane.solver.tolerance = scene.solver.tolerance/2;
  plane = exact_kind ().check (plane);
  system = surface_rod (plane);
  solver = struct ("name", "auto", "tolerance", plane.solver.tolerance, "seconds", seconds);
  times = frame_times (plane);
  [states, trial.count] = integrate (system, times, solver);
  none = 0*states(1:system.n,:);
  fields = system.fields (times, states(1:system.n,:), none, none, linspace (0, scene.rod.length, 21).');
  [trial.x, ~, trial.y] = system.surface.position (fields);
endfunction

%!test # a rod that hardly bends: the rigid pendulum
%! scene = setfield (setfield (swing (), "duration", 0.1), "frames_per_second", 20);
%! scene = setfield (check_scene (scene), "solver", "tolerance", 1e-4);
%! rung = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! assert (distance (exact_rod (scene, 5), trial_run (scene, rung)) < 1e-4);
%!error <given up after 0 s>
%! exact_rod (setfield (check_scene (swing ()), "solver", "tolerance", 1e-4), 5, 0);
