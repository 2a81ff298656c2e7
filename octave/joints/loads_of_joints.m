## -*- texinfo -*-
## @deftypefn {} {[@var{forces}, @var{moments}] =} loads_of_joints (@var{joints}, @var{place}, @var{t})
## The forces and moments among the @var{joints} (see @code{with_values}) at the times @var{t} (1-by-F, s), as
## @code{draw_pictures} takes them: structs of x, y, F_x, F_y and of x, y, M; on the first body, and against it on the
## second, whose points are where [x, y] = @var{place} (body, station) has them (1-by-F, m).
## @end deftypefn

function [forces, moments] = loads_of_joints (joints, place, t)
  forces = acting (joints, place, t, "force", {"F_x", "F_y"});
  moments = acting (joints, place, t, "moment", {"M"});
endfunction

function loads = acting (joints, place, t, kind, parts)
  loads = cell2struct (repmat ({zeros(0, numel (t))}, 1, 2 + numel (parts)), [{"x", "y"}, parts], 2);
  for joint = joints(:).'
    if (! strcmp (joint.kind, kind))
      continue;
    endif
    values = reshape (joint.value (t), numel (parts), []);
    for side = find (joint.bodies > 0)
      [loads.x(end+1,:), loads.y(end+1,:)] = place (joint.bodies(side), joint.stations(side));
      for k = 1:numel (parts)
        loads.(parts{k})(end+1,:) = (3 - 2*side)*values(k,:);
      endfor
    endfor
  endfor
endfunction

%!test # on one body, and between two
%! joints = struct ("kind", {"force", "spring", "force"}, "bodies", {[2 0], [1 0], [1 2]}, ...
%!                  "stations", {[0.3 0], [0 0], [0.1 0.2]}, "value", @(t) [t; 5*t](:).');
%! place = @(body, station) deal (body*[1 1], station*[1 1]);
%! [forces, moments] = loads_of_joints (joints, place, [1 2]);
%! assert ([forces.x, forces.y], [2 2 0.3 0.3; 1 1 0.1 0.1; 2 2 0.2 0.2]);
%! assert ([forces.F_x, forces.F_y], [1 2 5 10; 1 2 5 10; -1 -2 -5 -10]); assert (size (moments.M), [0 2]);
%! joints = setfield (joints(3), "kind", "moment");
%! joints.value = @(t) 7*t;
%! [forces, moments] = loads_of_joints (joints, place, [1 2]);
%! assert (moments, struct ("x", [1 1; 2 2], "y", [0.1 0.1; 0.2 0.2], "M", [7 14; -7 -14]));
%! assert (forces.x, zeros (0, 2));
