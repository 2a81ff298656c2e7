## -*- texinfo -*-
## @deftypefn {} {@var{angle} =} undeformed_angle (@var{rod}, @var{choice}, @var{station})
## The angle (rad) of the tangent of the undeformed @var{rod} of a checked scene at a @var{station} (m), in the rod's
## frame; @var{choice} is the scene's model, of which the section depends (see @code{rod_section}).
## @end deftypefn

function angle = undeformed_angle (rod, choice, station)
  base = struct ();
  if (! isempty (rod.curvature))
    base.axis = rod_axis (rod, 16, rod_section (rod, choice));
  endif
  [~, ~, angle] = undeformed_places (base, station);
endfunction

%!assert (undeformed_angle (struct ("curvature", []), [], 0.3), 0)
%!test # between its ends an arc turns by its length over its radius
%! scene = check_scene (arc_pendulum ());
%! ends = [undeformed_angle(scene.rod, scene.model, 0), undeformed_angle(scene.rod, scene.model, scene.rod.length)];
%! assert (abs (diff (ends)), abs (scene.rod.curvature)*scene.rod.length, 1e-9);
