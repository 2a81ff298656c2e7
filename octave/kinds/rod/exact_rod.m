## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} exact_rod (@var{scene}, @var{modes}, @var{seconds}, @var{before})
## The top rung of the ladder of models: the geometrically exact rod (see @code{exact_scene}) of a checked scene, in
## [@var{modes} @var{modes}] polynomials.  A struct of x and y (21-by-m, m), the centreline at the frame times, count,
## and run, that may lead the next one as @var{before}; empty where it has not what the scene has.  What takes more than
## so many @var{seconds} (default: any) is given up: an error.
## @end deftypefn

function trial = exact_rod (scene, modes, seconds = Inf, before = struct ("run", []))
  trial = [];
  plane = exact_scene (scene);
  if (isempty (plane))
    return;
  endif
  plane.model.modes = [modes modes];
  plane.solver.name = "auto";
  plane.solver.tolerance = scene.solver.tolerance/2;
  kind = exact_kind ();
  plane = kind.check (plane);
  run = run_model (kind, plane, surface_rod (plane), setfield (plane.solver, "seconds", seconds), before.run);
  trial = struct ("x", run.x(1:5:end,:), "y", run.z(1:5:end,:), "count", run.count, "run", run);
endfunction

%!test # a rod that hardly bends: the rigid pendulum
%! scene = setfield (setfield (swing (), "duration", 0.1), "frames_per_second", 20);
%! scene = setfield (check_scene (scene), "solver", "tolerance", 1e-4);
%! rung = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! assert (distance (exact_rod (scene, 5), trial_run (scene, rung)) < 1e-4);
%!error <given up after 0 s>
%! exact_rod (setfield (check_scene (swing ()), "solver", "tolerance", 1e-4), 5, 0);
