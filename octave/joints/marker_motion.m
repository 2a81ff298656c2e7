## -*- texinfo -*-
## @deftypefn {} {@var{at} =} marker_motion (@var{mechanism}, @var{k}, @var{motion_of})
## Where the markers of a @var{mechanism} are and how they move, in @var{k} states (times or stages) in which the
## bodies of a marker group (see @code{list_markers}) have the motion @var{motion_of} (group), a struct as of
## @code{motion_of_rods}, of V (n-by-(bodies k)) and so on: a struct of x, y, angle, their rates x_dot, y_dot,
## angle_dot (markers-by-k), and parts (what forces on each marker group need: index (coordinates-by-bodies), numbers,
## the derivatives x_phi, y_phi (1-by-(bodies k)), x_V, y_V and angle_V (n-by-(bodies k)), or 0).  What no joint sees
## of a group, its points or its tangents, is left at 0.
## @end deftypefn

function at = marker_motion (mechanism, k, motion_of)
  ground = mechanism.ground;
  fixed = ones (1, k);
  at = struct ("x", ground.x*fixed, "y", ground.y*fixed, "angle", ground.angle*fixed);
  at.x_dot = at.y_dot = at.angle_dot = zeros (mechanism.marker_count, k);
  at.parts = cell (1, numel (mechanism.markers));
  for g = 1:numel (mechanism.markers)
    group = mechanism.markers(g);
    i = group.numbers;
    bodies = numel (i);
    motion = motion_of (group);
    equations = mechanism.groups(group.group).model.equations;
    part = struct ("index", group.index, "numbers", i, "x_phi", 0, "y_phi", 0, "x_V", 0, "y_V", 0, "angle_V", 0);
    if (group.sees_point)
      [x, y, x_dot, y_dot, part.x_phi, part.y_phi, part.x_V, part.y_V] = equations.point (motion, group.marker);
      at.x(i,:) = reshape (x, bodies, k);
      at.y(i,:) = reshape (y, bodies, k);
      at.x_dot(i,:) = reshape (x_dot, bodies, k);
      at.y_dot(i,:) = reshape (y_dot, bodies, k);
    endif
    if (group.sees_tangent)
      [angle, angle_dot, part.angle_V] = equations.tangent (motion, group.marker);
      at.angle(i,:) = reshape (angle, bodies, k);
      at.angle_dot(i,:) = reshape (angle_dot, bodies, k);
    endif
    at.parts{g} = part;
  endfor
endfunction

%!test # rates and derivatives are those of the places
%! [system, q, v, h] = sample_state ();
%! at = @(q) markers_of_states (system.mechanism, q, v);
%! [back, here, on] = deal (at (q - h*v), at (q), at (q + h*v));
%! assert ((on.x - back.x)/(2*h), here.x_dot, 1e-7);
%! assert ((on.angle - back.angle)/(2*h), here.angle_dot, 1e-7);
%! part = here.parts{1};
%! y_q = [part.y_V(:,1); part.y_phi(1); 0; 1];
%! assert (sum (y_q.*v(part.index(:,1))), here.y_dot(part.numbers(1)), 1e-12);
%!test # tangents alone, where nothing sees the point
%! [system, q, v] = sample_state ();
%! mechanism = list_markers (system.mechanism, struct ("kind", "moment", "bodies", [2 0], "stations", [0.25 0], ...
%!                                                     "point", [0 0], "direction", 0));
%! at = markers_of_states (mechanism, q, v);
%! assert (at.x, [0; 0]); assert (at.angle(1) != 0); assert (at.parts{1}.x_V, 0);
