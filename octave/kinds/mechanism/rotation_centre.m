## -*- texinfo -*-
## @deftypefn {} {@var{centre} =} rotation_centre (@var{scene})
## The point [x y] (m) about which all bodies of a checked @var{scene} can turn as one: where the ground holds them by
## joints "revolute" at one point, and beside these by no joint but "angle", the hub that turns them, and loads.
## Anything else on the ground is an error, and so is none.
## @end deftypefn

function centre = rotation_centre (scene)
  centre = [];
  for joint = scene.joints(:).'
    if (all (joint.bodies > 0) || strcmp (joint.kind, "angle") || is_load (joint))
      continue;
    endif
    if (! strcmp (joint.kind, "revolute"))
      scene_error (["no steady rotation: %s, a joint \"%s\", holds a body to the ground; all can turn about a point" ...
                    " alone, \"revolute\", driven by \"angle\""], joint.name, joint.kind);
    elseif (! isempty (centre) && norm (joint.point(:).' - centre) > 1e-9*max ([1, norm(centre)]))
      scene_error ("no steady rotation: %s holds a body to another point of the ground, (%g, %g) and not (%g, %g)", ...
                   joint.name, joint.point, centre);
    endif
    centre = joint.point(:).';
  endfor
  if (isempty (centre))
    scene_error ("no steady rotation: no joint \"revolute\" holds a body to the ground, about which all turn");
  endif
endfunction

%!function scene = held (varargin)
%!  rod = struct ("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1));
%!  scene = check_mechanism (struct ("bodies", {{rod, rod}}, "joints", {varargin}, "duration", 1));
%!endfunction
%!test
%! hinge = @(body, x) struct ("kind", "revolute", "bodies", body, "stations", 0, "point", [x 2]);
%! angle = struct ("kind", "angle", "bodies", 1, "stations", 0);
%! spring = struct ("kind", "torsion_spring", "bodies", [1 2], "stations", [1 1], "stiffness", 1);
%! assert (rotation_centre (held (hinge (1, 1), hinge (2, 1), angle, spring)), [1 2]);
%! fail ("rotation_centre (held (hinge (1, 1), hinge (2, 3)))", "joint 2 holds a body to another point of the ground");
%!error <joint 1, a joint "weld", holds a body to the ground> rotation_centre (check_mechanism (struct ("bodies", ...
%!  {{struct("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1))}}, "duration", 1, ...
%!  "joints", {{struct("kind", "weld", "bodies", 1, "stations", 0)}})));
%!error <no joint "revolute" holds a body> rotation_centre (struct ("joints", []));
