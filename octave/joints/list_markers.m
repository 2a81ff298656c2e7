## -*- texinfo -*-
## @deftypefn {} {@var{mechanism} =} list_markers (@var{mechanism}, @var{joints})
## A @var{mechanism}, of which groups and place count here (see @code{build_mechanism}), with the markers of its
## @var{joints}: marker_of (joints-by-2: the markers of each joint, numbered), ground (x, y, angle: those of markers
## on the ground, 0 of the others) and markers (markers of equal bodies at one station, a group each: group, index
## (coordinates, a column a body), numbers (of the markers), marker (see @code{matrix_equations}), sees_point,
## sees_tangent: whether a joint does).
## @end deftypefn

function mechanism = list_markers (mechanism, joints)
  known = zeros (0, 2);  # body, station
  mechanism.marker_of = zeros (numel (joints), 2);
  on_ground = zeros (0, 2);  # joint, side
  for j = 1:numel (joints)
    for side = 1:2
      body = joints(j).bodies(side);
      station = joints(j).stations(side);
      if (body == 0)
        on_ground(end+1,:) = [j, side];
        continue;
      endif
      number = find (known(:,1) == body & known(:,2) == station);
      if (isempty (number))
        known(end+1,:) = [body, station];
        number = rows (known);
      endif
      mechanism.marker_of(j,side) = number;
    endfor
  endfor
  mechanism.marker_body = known(:,1);
  mechanism.marker_station = known(:,2);
  mechanism.markers = grouped (known, mechanism, joints);
  count = rows (known);
  mechanism.ground.x = mechanism.ground.y = mechanism.ground.angle = zeros (count + rows (on_ground), 1);
  for i = 1:rows (on_ground)
    count++;
    j = on_ground(i,1);
    mechanism.marker_of(j,on_ground(i,2)) = count;
    mechanism.ground.x(count) = joints(j).point(1);
    mechanism.ground.y(count) = joints(j).point(2);
    mechanism.ground.angle(count) = joints(j).direction;
  endfor
  mechanism.marker_count = count;
endfunction

function groups = grouped (known, mechanism, joints)
  groups = struct ([]);
  place = mechanism.place(known(:,1),:);
  for pair = unique ([place(:,1), known(:,2)], "rows").'
    numbers = find (place(:,1) == pair(1) & known(:,2) == pair(2)).';
    bodies = mechanism.groups(pair(1));
    groups(end+1) = struct ("group", pair(1), "index", bodies.index(:,place(numbers,2)), "numbers", numbers, ...
                            "marker", bodies.model.equations.marker (bodies.model, pair(2)), ...
                            "sees_point", any_sees (joints, mechanism, numbers, "point"), ...
                            "sees_tangent", any_sees (joints, mechanism, numbers, "tangent"));
  endfor
endfunction

## whether a joint at markers of these numbers sees such of its bodies
function yes = any_sees (joints, mechanism, numbers, what)
  sees = arrayfun (@(joint) any (strcmp (joint_kind (joint.kind).sees, what)), joints(:));
  yes = any (any (ismember (mechanism.marker_of, numbers), 2) & sees);
endfunction

%!test # equal rods at equal stations are one group
%! mechanism = sample_mechanism ([0 1]).mechanism;
%! assert (mechanism.marker_count, 10);
%! assert (isequal (sort ([mechanism.markers.numbers]), 1:7));
