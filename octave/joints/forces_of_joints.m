## -*- texinfo -*-
## @deftypefn {} {@var{forces} =} forces_of_joints (@var{joints}, @var{place}, @var{t})
## The forces among the @var{joints} (see @code{with_values}) at the times @var{t} (1-by-F, s), as @code{draw_pictures}
## takes them: a struct of x, y, F_x, F_y; on the first body, and against it on the second, whose points are where
## [x, y] = @var{place} (body, station) has them (1-by-F, m).
## @end deftypefn

function forces = forces_of_joints (joints, place, t)
  none = zeros (0, numel (t));
  forces = struct ("x", none, "y", none, "F_x", none, "F_y", none);
  for joint = joints(:).'
    if (! strcmp (joint.kind, "force"))
      continue;
    endif
    F = reshape (joint.value (t), 2, []);
    for side = find (joint.bodies > 0)
      [forces.x(end+1,:), forces.y(end+1,:)] = place (joint.bodies(side), joint.stations(side));
      forces.F_x(end+1,:) = (3 - 2*side)*F(1,:);
      forces.F_y(end+1,:) = (3 - 2*side)*F(2,:);
    endfor
  endfor
endfunction

%!test # on one body, and between two
%! joints = struct ("kind", {"force", "moment", "force"}, "bodies", {[2 0], [1 0], [1 2]}, ...
%!                  "stations", {[0.3 0], [0 0], [0.1 0.2]}, "value", @(t) [t; 5*t](:).');
%! forces = forces_of_joints (joints, @(body, station) deal (body*[1 1], station*[1 1]), [1 2]);
%! assert ([forces.x, forces.y], [2 2 0.3 0.3; 1 1 0.1 0.1; 2 2 0.2 0.2]);
%! assert ([forces.F_x, forces.F_y], [1 2 5 10; 1 2 5 10; -1 -2 -5 -10]);
