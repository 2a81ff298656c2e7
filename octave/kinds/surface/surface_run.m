## -*- texinfo -*-
## @deftypefn {} {@var{run} =} surface_run (@var{scene}, @var{modes}, @var{balance})
## The motion of the rod of a checked scene on its surface with these numbers of polynomials, @var{modes} = [N1 N2]: a
## struct of the scene with them, system, history and count (see @code{run_surface}, also for @var{balance}), and the
## centreline x, y, z (101 stations by frames, m).
## @end deftypefn

function run = surface_run (scene, modes, balance)
  scene.model.modes = modes;
  run.scene = scene;
  run.system = surface_rod (scene);
  [run.history, run.count] = run_surface (run.system, scene, balance);
  for axis = {"x", "y", "z"}
    run.(axis{1}) = run.history.(axis{1});
  endfor
endfunction

%!test
%! scene = check_surface_scene (setfield (large_swing (), "duration", 0.04));
%! run = surface_run (scene, [5 5], 3e-9);
%! assert (size (run.z), [101 3]); assert (run.scene.model.modes, [5 5]);
