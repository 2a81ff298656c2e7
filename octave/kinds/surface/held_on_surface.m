## -*- texinfo -*-
## @deftypefn {} {[@var{loads}, @var{springs}] =} held_on_surface (@var{scene}, @var{base_at})
## What acts at places of the rod of a checked scene on a surface.  @var{base_at} (stations, weights) are its base
## functions there with weights (see @code{surface_basis}).
##
## @var{loads}: stations (s-by-1, m), base there, values (a cell array of functions of times, which return the numbers
## of each time behind those of the one before), and rows (which of the 4s numbers force_1, force_2, force_3 and moment,
## each at all stations, they are).  @var{springs}: stations, base, point (a row [x y z] each), stiffness, damping and
## rest (columns) and names.
## @end deftypefn

function [loads, springs] = held_on_surface (scene, base_at)
  l = scene.rod.length;
  held = {"moment", scene.moment, 0; "moment", scene.tip_moment, l; "force", scene.force, scene.force_station};
  names = {"moment", "tip_moment", "force"};
  acts = cellfun (@(value) ! isnumeric (value) || any (value), held(:,2)).';
  for k = find (acts)
    held{k,2} = watched_columns (names{k}, held{k,2});
  endfor
  held = held(acts,:);
  for joint = scene.joints(is_load (scene.joints))
    held(end+1,:) = {joint.kind, joint.value, joint.stations};
  endfor
  loads.stations = unique ([held{:,3}]).';
  loads.base = base_at (loads.stations, ones (size (loads.stations)));
  loads.values = held(:,2);
  loads.rows = cell (rows (held), 1);
  places = numel (loads.stations);
  for k = 1:rows (held)
    component = 4;
    if (strcmp (held{k,1}, "force"))
      component = 1:3;
    endif
    loads.rows{k} = find (loads.stations == held{k,3}) + places*(component - 1);
  endfor
  list = scene.joints(! is_load (scene.joints));  # springs
  column = @(name) vertcat (zeros (0, 1), list.(name));
  springs = struct ("stations", column ("stations"), "base", base_at (column ("stations"), ...
                    ones (numel (list), 1)), ...
                    "point", vertcat (zeros (0, 3), list.point), "stiffness", column ("stiffness"), ...
                    "damping", column ("damping"), "rest", column ("rest"), "names", {{list.name}});
endfunction

%!test # where there is nothing, and two springs
%! base_at = @(stations, weights) numel (stations);
%! [loads, springs] = held_on_surface (check_surface_scene (on_level_plane ()), base_at);
%! assert (isempty (loads.values)); assert (springs.base, 0); assert (size (springs.point), [0 3]);
%! spring = struct ("kind", "spring", "stations", 1, "point", [1 2 3], "stiffness", 4);
%! scene = on_level_plane ("moment", 2, "force", @(t) [t 0 0]);
%! scene.joints = {spring, setfield(spring, "rest", 7)};
%! [loads, springs] = held_on_surface (check_surface_scene (scene), base_at);
%! assert (loads.stations, [0; 2]); assert (loads.rows, {7; [2 4 6]});
%! assert ([springs.stiffness, springs.rest, springs.point], [4 0 1 2 3; 4 7 1 2 3]);
