## -*- texinfo -*-
## @deftypefn {} {@var{places} =} marker_places (@var{mechanism}, @var{q})
## The points and tangents of all markers of a @var{mechanism} in the states @var{q} (n-by-k), seen by a joint or not: a
## struct of x, y (m) and angle (rad; markers-by-k).
## @end deftypefn

function places = marker_places (mechanism, q)
  at = markers_of_states (seen_whole (mechanism), q, 0*q);
  places = struct ("x", at.x, "y", at.y, "angle", at.angle);
endfunction

%!test # of a moment, too
%! [system, q] = sample_state ();
%! moment = struct ("kind", "moment", "bodies", [2 0], "stations", [0 0], "point", [3 4], "direction", 0);
%! index = index_of (system.mechanism, 2);
%! places = marker_places (list_markers (system.mechanism, moment), q);
%! assert (places.x, [q(index(end-1)); 3], 1e-15); assert (places.y, [q(index(end)); 4], 1e-15);
%! assert (places.angle(2), 0);
