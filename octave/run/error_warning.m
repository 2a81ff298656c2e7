## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} error_warning (@var{scene}, @var{estimate})
## A cellstr: empty, or a warning that the estimated error (see @code{estimate_error}) is beyond the scene's tolerance,
## with what the models drop, where that is the cause, and what to take instead.
## @end deftypefn

function warnings = error_warning (scene, estimate)
  warnings = {};
  tolerance = scene.solver.tolerance;
  if (estimate.metres <= tolerance)
    return;
  endif
  remedy = "take a smaller tolerance or another solver";
  if (estimate.dropped > tolerance)
    remedy = sprintf ("%.2g m of it is what all these models drop beyond foreshortening: %s", estimate.dropped, ...
                      instead (scene));
  elseif (estimate.of_choice <= tolerance)
    remedy = sprintf (["%.2g m of it may be what all these models drop beyond foreshortening: take half the" ...
                       " tolerance, or %s"], estimate.dropped, instead (scene));
  endif
  warnings = {sprintf("the estimated error is %.2g m, the tolerance %.2g m: %s", estimate.metres, tolerance, remedy)};
endfunction

## a rod on a plane is exact, but has neither hub nor tip mass, damping or a force on the way
function text = instead (scene)
  text = "several shorter rods welded together (scene.bodies, joints of the kind \"weld\") bend less each";
  if (isfield (scene, "rod") && isempty (scene.rotation) && isempty (scene.force) && scene.tip_mass == 0 ...
      && scene.rod.damping == 0)
    text = "the rod on an upright plane, scene.surface.name = \"plane\", is geometrically exact";
  endif
endfunction

%!function text = said (scene, metres, of_choice, dropped)
%!  scene = check_scene (setfield (scene, "solver", "tolerance", 1e-4));
%!  estimate = struct ("metres", metres, "of_choice", of_choice, "dropped", dropped);
%!  text = [error_warning(scene, estimate){:}];
%!endfunction
%!assert (isempty (said (slender (), 9e-5, 9e-5, 0)))
%!assert (regexp (said (slender (), 2e-4, 2e-4, 0), "error is 0.0002 m, the tolerance 0.0001 m: take a smaller"), 15)
%!assert (regexp (said (slender (), 2e-4, 2e-4, []), "error is 0.0002 m, the tolerance 0.0001 m: take a smaller"), 15)
%!test
%! text = said (slender (), 3e-3, 4e-5, 3.2e-3);
%! assert (! isempty (regexp (text, "0.0032 m of it is what all .* drop .*: the rod on an upright plane")), text);
%! text = said (spin_up (), 3e-3, 4e-5, 3.2e-3);
%! assert (! isempty (regexp (text, "0.0032 m of it is what all these models drop .* rods welded together")), text);
