## -*- texinfo -*-
## @deftypefn {} {@var{springs} =} springs_of_joints (@var{joints}, @var{place}, @var{frames})
## The springs and torsion springs among the @var{joints} of a run of so many @var{frames}, as @code{draw_pictures}
## takes them: a struct of x, y, to_x, to_y and shape. Bodies have their points where [x, y] = @var{place} (body,
## station) has them (1-by-frames, m).
## @end deftypefn

function springs = springs_of_joints (joints, place, frames)
  shapes = struct ("spring", "coil", "torsion_spring", "spiral");
  springs = struct ("x", zeros (0, frames), "y", zeros (0, frames), "to_x", zeros (0, frames), ...
                    "to_y", zeros (0, frames), "shape", {cell(0, 1)});
  for joint = joints(:).'
    if (! isfield (shapes, joint.kind))
      continue;
    endif
    [springs.x(end+1,:), springs.y(end+1,:)] = place (joint.bodies(1), joint.stations(1));
    if (joint.bodies(2) > 0)
      [springs.to_x(end+1,:), springs.to_y(end+1,:)] = place (joint.bodies(2), joint.stations(2));
    else
      springs.to_x(end+1,:) = joint.point(1);
      springs.to_y(end+1,:) = joint.point(2);
    endif
    springs.shape{end+1,1} = shapes.(joint.kind);
  endfor
endfunction

%!test # between two bodies, and from one to the ground
%! joints = struct ("kind", {"revolute", "spring", "torsion_spring"}, "bodies", {[1 2], [1 2], [2 0]}, ...
%!                  "stations", {[0 0], [0.2 0.3], [0.4 0]}, "point", {[0 0], [0 0], [7 8]});
%! springs = springs_of_joints (joints, @(body, station) deal (body*[1 2], station*[1 1]), 2);
%! assert ([springs.x, springs.y], [1 2 0.2 0.2; 2 4 0.4 0.4]);
%! assert ([springs.to_x, springs.to_y], [2 4 0.3 0.3; 7 7 8 8]);
%! assert (springs.shape, {"coil"; "spiral"});
%!assert (springs_of_joints (struct ([]), [], 3).x, zeros (0, 3))
