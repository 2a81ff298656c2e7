## -*- texinfo -*-
## @deftypefn {} {[@var{place}, @var{velocity}] =} placed_by_joints (@var{scene}, @var{mechanism}, @var{place}, @
##   @var{velocity})
## Places (m) and velocities (m/s) of the bodies' points O, a row a body, where some are stated and others NaN: a body
## is where its first joint with a body that has its place, or with the ground, puts its point, and moves as that point
## does, unless its velocity is stated.  It goes joint after joint, until none places another body; what hangs on
## nothing is at the origin, at rest.
## @end deftypefn

function [place, velocity] = placed_by_joints (scene, mechanism, place, velocity)
  do
    without_place = sum (isnan (place(:,1)));
    for joint = scene.joints(:).'
      if (any (strcmp (joint.kind, {"revolute", "weld", "position", "bushing"})))
        for side = 1:2
          [place, velocity] = place_body (scene, mechanism, joint, side, place, velocity);
        endfor
      endif
    endfor
  until (sum (isnan (place(:,1))) == without_place)
  place(isnan (place)) = 0;
  velocity(isnan (velocity)) = 0;
endfunction

## the body on that side of a joint, if it has no place yet, and the other side has one
function [place, velocity] = place_body (scene, mechanism, joint, side, place, velocity)
  body = joint.bodies(side);
  other = joint.bodies(3-side);
  if (body == 0 || ! isnan (place(body,1)) || (other > 0 && isnan (place(other,1))))
    return;
  endif
  from_O = @(body, side) point_of (scene.bodies(body).initial, mechanism.models{body}.base, joint.stations(side));
  point = joint.point(:).';
  rate = [0 0];
  if (other > 0)
    [point, rate] = from_O (other, 3 - side);
    point += place(other,:);
    rate += velocity(other,:);
  endif
  if (strcmp (joint.kind, "position"))
    offset = joint.value (0);  # of the first side's point from the second's
    if (side == 2)
      offset = -offset;
    endif
    point += offset(1,:);
    rate += offset(2,:);
  endif
  [own_point, own_rate] = from_O (body, side);
  place(body,:) = point - own_point;
  if (isnan (velocity(body,1)))
    velocity(body,:) = rate - own_rate;
  endif
endfunction

## from O, of the undeformed rod
function [point, rate] = point_of (initial, base, station)
  [x_0, y_0] = undeformed_places (base, station);
  [x, y] = rod_centreline (initial.phi, x_0, y_0*0, y_0);
  point = [x, y];
  rate = initial.phi_dot*[-y, x];
endfunction

%!function [place, velocity] = placed (scene)
%!  scene = check_mechanism (scene);
%!  none = NaN (numel (scene.bodies), 2);
%!  mechanism = build_mechanism (scene, mechanism_rungs (scene, zeros (1, rows (none))));
%!  [place, velocity] = placed_by_joints (scene, mechanism, none, none);
%!endfunction
%!test # a place that is prescribed, and its rate, put a rod's point there, whichever side of the joint it is on
%! rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1);
%! scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 0]), "initial", struct ("phi", pi/2, ...
%!   "phi_dot", 2))};
%! scene.joints = {struct("kind", "position", "bodies", 1, "stations", 0.5, "point", [3 0], ...
%!                        "value", @(t) [0.2+t 0.1+5*t; 1 5; 0 0])};
%! scene.duration = 1;
%! [place, velocity] = placed (scene);
%! assert (place, [3.2 -0.4], 1e-12); assert (velocity, [1+1 5], 1e-12);
%! scene = struct ("duration", 1, "bodies", {{struct("rod", rod, "model", struct ("modes", [0 0])), ...
%!                                            struct("rod", rod, "model", struct ("modes", [0 0]))}});
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "position", "bodies", [1 2], "stations", [1 0], ...
%!                        "value", @(t) [0.2+3*t 0.1+4*t; 3 4; 0 0])};
%! [place, velocity] = placed (scene);
%! assert (place, [0 0; 0.8 -0.1], 1e-12); assert (velocity, [0 0; -3 -4], 1e-12);
