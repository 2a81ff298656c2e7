## -*- texinfo -*-
## @deftypefn {} {@var{mechanism} =} list_markers (@var{mechanism}, @var{joints})
## The @var{mechanism} with the markers of its @var{joints}: marker_of (joints-by-2: the markers of each joint,
## numbered), ground (x, y, angle of those on the ground) and markers (markers of equal bodies at one station,
## a group each: group, columns (of the group's bodies), numbers (of the markers), marker (as
## @code{rod_marker} takes it)).
## @end deftypefn

function mechanism = list_markers (mechanism, joints)
  known = zeros (0, 2);  # body, station
  mechanism.marker_of = zeros (numel (joints), 2);
  mechanism.ground = struct ("number", zeros (1, 0), "x", zeros (0, 1), "y", zeros (0, 1), ...
                             "angle", zeros (0, 1));
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
  mechanism.markers = grouped (known, mechanism);
  count = rows (known);
  for i = 1:rows (on_ground)
    count++;
    j = on_ground(i,1);
    mechanism.marker_of(j,on_ground(i,2)) = count;
    mechanism.ground.number(end+1) = count;
    mechanism.ground.x(end+1,1) = joints(j).point(1);
    mechanism.ground.y(end+1,1) = joints(j).point(2);
    mechanism.ground.angle(end+1,1) = joints(j).direction;
  endfor
  mechanism.marker_count = count;
endfunction

function groups = grouped (known, mechanism)
  groups = struct ([]);
  place = mechanism.place(known(:,1),:);
  for pair = unique ([place(:,1), known(:,2)], "rows").'
    numbers = find (place(:,1) == pair(1) & known(:,2) == pair(2)).';
    model = mechanism.groups(pair(1)).model;
    groups(end+1) = struct ("group", pair(1), "columns", place(numbers,2).', "numbers", numbers, ...
                            "marker", marker_at (model, pair(2)));
  endfor
endfunction

function marker = marker_at (model, station)
  [along, across] = functions_at (model.base, station);
  [slope_1, slope_2] = slopes_at (model.base, station, model.shortening);
  [x, y, direction] = undeformed_places (model.base, station);
  marker = struct ("place_1", x, "place_2", y, "direction", direction, "shape_1", along.', "shape_2", across.', ...
                   "slope_1", slope_1, "slope_2", slope_2, ...
                   "shortening_matrix", model.shortening*shortening_at (model.base, station));
endfunction

%!test # equal rods at equal stations are one group
%! mechanism = sample_mechanism ([0 1]).mechanism;
%! assert (mechanism.marker_count, 10);
%! assert (isequal (sort ([mechanism.markers.numbers]), 1:7));
