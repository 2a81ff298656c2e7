## -*- texinfo -*-
## @deftypefn {} {@var{motion} =} far_richer (@var{result})
## The motion (see @code{motion_of}) of the scene of a @var{result} of @code{driver} by a far richer model of the same
## physics with far smaller tolerances: 30 + 30 modes and foreshortening of a straight rod, at a fiftieth of the
## tolerance, moved by what all such models drop (see @code{dropped_error}); 27 + 40 base functions of a curved one;
## 2 n + 6 modes for n of each kind of the rods of a mechanism, at a twentieth; twice as many polynomials on a surface.
## @end deftypefn

function motion = far_richer (result)
  scene = result.scene;
  [scene.solver.name, scene.solver.step] = deal ("auto", []);
  scene.solver.tolerance /= 50;
  if (isfield (scene, "bodies"))
    scene.solver.tolerance *= 2.5;
    modes = vertcat (result.summary.modes{:});
    motion = mechanism_trial (scene, mechanism_rungs (scene, 2*modes(:,2).' + 6, 2*modes(:,1).' + 6));
  elseif (isfield (scene, "surface"))
    scene.model.modes = min (2*result.scene.model.modes, 32);
    system = surface_rod (scene);
    history = run_surface (system, scene);
    motion = motion_of (struct ("scene", scene, "history", history));
  else
    rich = struct ("sines", [], "bending", 30, "longitudinal", 30, "axial", "dynamic", "stiffening", "foreshortening");
    if (! isempty (scene.rod.curvature))
      rich = setfield (setfield (rich, "sines", [27 40]), "stiffening", "none");
    endif
    motion = trial_run (scene, rich);
    if (! isempty (motion.error))
      error ("toolchain:integration", "%s\n", motion.error);
    elseif (isempty (scene.rod.curvature))
      scene.solver.tolerance *= 5;  # it is a difference of motions
      dropped = dropped_error (scene, motion.model, motion.history);
      [motion.x, motion.y] = deal (motion.x + dropped.x, motion.y + dropped.y);
    endif
  endif
endfunction

%!test # of a rod that needs no modes it is the same motion
%! result = driver (setfield (swing (), "duration", 0.2), "output", "");
%! assert (result.summary.estimated_error_m > 0);
%! off = distance (motion_of (result), far_richer (result));
%! assert (off > 0 && off < result.summary.tolerance_m/20);
