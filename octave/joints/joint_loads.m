## -*- texinfo -*-
## @deftypefn {} {@var{loads} =} joint_loads (@var{joints}, @var{dimension})
## The values of a scene's @var{joints} that are functions of time, loads and prescribed motions, as the struct array
## of @code{load_list}, in a space of so many @var{dimension}s (2: the plane).
## @end deftypefn

function loads = joint_loads (joints, dimension = 2)
  rows = cell (0, 6);
  for k = 1:numel (joints)
    [numbers, orders] = value_size (joints(k), dimension);
    all = numbers*orders;
    takes = how_many (all, "number");
    prescribed = [];
    if (orders == 3)
      takes = sprintf ("%d numbers, a row each for place, rate and acceleration", all);
      prescribed = find (mod (1:all, 3) > 0);
    endif
    if (all > 0)
      rows(end+1,:) = {joints(k).value_name, joints(k).value, all, takes, prescribed, false};
    endif
  endfor
  loads = load_list (rows);
endfunction

%!test # a force and a prescribed place; a number and a revolute joint are none
%! kinds = {"revolute", "force", "position", "moment"};
%! names = {"hinge", "joints(2).value", "joints(3).value", "moment"};
%! joints = struct ("kind", kinds, "value", {0, @(t) [1 t], @(t) zeros (3, 2), 5}, "value_name", names);
%! loads = joint_loads (joints);
%! assert ({loads.name}, {"joints(2).value", "joints(3).value"});
%! assert (loads(2).prescribed, [1 2 4 5]); assert (loads(2).numbers, 6);
%!assert (isempty (joint_loads (struct ("kind", {}, "value", {}))))
