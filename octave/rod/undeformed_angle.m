## -*- texinfo -*-
## @deftypefn {} {@var{angle} =} undeformed_angle (@var{body}, @var{station})
## The angle (rad) of the tangent of the undeformed rod of a @var{body} of a checked mechanism, or of a checked scene,
## at a @var{station} (m), in the rod's frame.
## @end deftypefn

function angle = undeformed_angle (body, station)
  base = struct ();
  if (! isempty (body.rod.curvature))
    base.axis = rod_axis (body.rod, 16, rod_section (body.rod, body.model), body.tip_mass);
  endif
  [~, ~, angle] = undeformed_places (base, station);
endfunction

%!assert (undeformed_angle (struct ("rod", struct ("curvature", [])), 0.3), 0)
%!test # between its ends an arc turns by its length over its radius
%! scene = check_scene (arc_pendulum ());
%! ends = [undeformed_angle(scene, 0), undeformed_angle(scene, scene.rod.length)];
%! assert (abs (diff (ends)), abs (scene.rod.curvature)*scene.rod.length, 1e-9);
