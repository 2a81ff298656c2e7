## -*- texinfo -*-
## @deftypefn {} {@var{dropped} =} dropped_of_curved (@var{scene}, @var{run}, @var{reference})
## What all models of a curved rod drop in the motion of a @var{run}, since their strains are linear in displacements:
## a struct as of @code{dropped_error}.  It is how far the geometrically exact rod is from the richer @var{reference},
## known to a tenth (see @code{exact_runs}).
##
## Where the bound of @code{bound_of_curved} is below a fifth of the tolerance, or where there is no such rod, or it
## takes more than half a minute, that bound is taken.
## @end deftypefn

function dropped = dropped_of_curved (scene, run, reference)
  metres = bound_of_curved (run.model, run.history.V, scene.duration);
  dropped = struct ("metres", metres, "x", 0*reference.x, "y", 0*reference.y, "bound", metres);
  if (metres < scene.solver.tolerance/5)
    return;
  endif
  near = @(exact) max (scene.solver.tolerance, distance (exact, reference))/10;
  [exact, known] = exact_runs (curved_kind (), scene, 30, near);
  if (known)
    dropped = struct ("metres", distance (exact, reference), "x", exact.x - reference.x, "y", exact.y - reference.y, ...
                      "bound", exact.off);
  endif
endfunction

%!function [dropped, scene, run] = of_arc (duration, half_height = 0.003)
%!  scene = setfield (setfield (arc_pendulum (), "duration", duration), "rod", "half_height", half_height);
%!  scene = check_scene (scene);
%!  run = run_model (curved_kind (), scene, build_curved_model (scene, curved_rung ([3 6])));
%!  evalc ("dropped = dropped_of_curved (scene, run, run);");
%!endfunction
%!test # the exact rod is 4 mm elsewhere after 0.7 s, and the bound is above that
%! [dropped, scene, run] = of_arc (0.7);
%! far = struct ("x", run.x + dropped.x, "y", run.y + dropped.y);
%! exact = exact_body (setfield (scene, "solver", "tolerance", 1e-5));
%! rod = run_model (exact_body_kind (), exact, exact_body_kind ().sized (exact, 14));
%! assert (distance (far, rod) < 0.1*dropped.metres);
%! assert (dropped.metres > 1e-3 && dropped.bound < 0.1*dropped.metres);
%! bounded = dropped_of_curved (setfield (scene, "solver", "tolerance", 1), run, run);
%! assert (bounded.metres, bounded.bound); assert (any ([bounded.x(:); bounded.y(:)]), false);
%! assert (bounded.metres > dropped.metres && bounded.metres < 10*dropped.metres);
%!test # without an exact rod, or of a rod that is rigid
%! dropped = of_arc (0.1, 0.05);
%! assert (dropped.metres, dropped.bound); assert (dropped.metres > 0);
%! [~, scene] = of_arc (0.1);
%! rigid = run_model (curved_kind (), scene, build_curved_model (scene, curved_rung ([0 0])));
%! assert (dropped_of_curved (scene, rigid, rigid).metres, 0);
