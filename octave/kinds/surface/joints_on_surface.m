## -*- texinfo -*-
## @deftypefn {} {[@var{joints}, @var{loads}] =} joints_on_surface (@var{scene})
## The joints of a @var{scene} of a rod on a surface with all their fields (see @code{joint_fields}), checked: forces,
## moments about the normal, and springs from a point in space, each at one of the rod's stations.  Values come back as
## functions of t as those of @code{joint_value}, points as rows [x y z]; @var{loads} are those that hang on time (see
## @code{load_list}).
## @end deftypefn

function [joints, loads] = joints_on_surface (scene)
  fields = joint_fields ();
  fields{strcmp (fields(:,1), "bodies"),2} = 1;
  fields(strcmp (fields(:,1), "point"),2:3) = {[0 0 0], "vector [x y z] of a place in space in m"};
  joints = take_list (scene.joints, fields, "joints", "joint", @(joint, what) check_joint (joint, what, scene.rod));
  loads = joint_loads (joints, 3);
  for k = 1:numel (joints)
    watched = watched_columns (joints(k).value_name, joints(k).value);
    joints(k).value = @(t) reshape (watched (t), 1, []);
  endfor
endfunction

function joint = check_joint (joint, what, rod)
  if (! any (strcmp (joint.kind, {"force", "moment", "spring"})))
    scene_error ("%s.kind is \"%s\": a rod on a surface takes \"force\", \"moment\" and \"spring\"", what, joint.kind);
  elseif (! any (joint.bodies(:).' == 1) || any (joint.bodies > 1))
    scene_error ("%s.bodies is [%s]: there is one rod", what, num2str (joint.bodies(:).'));
  elseif (! isscalar (joint.stations))
    scene_error ("%s.stations are [%s]: it takes one station on the rod", what, num2str (joint.stations(:).'));
  elseif (numel (joint.point) != 3)
    scene_error ("%s.point has %d numbers: it takes [x y z] in m", what, numel (joint.point));
  endif
  joint.stations = station_on_rod ([what ".stations"], joint.stations, rod.length);
  joint.point = joint.point(:).';
  joint.value_name = value_name (what);
  count = value_size (joint, 3);
  if (isnumeric (joint.value) && numel (joint.value) != count && count > 0)
    scene_error ("%s.value has %d numbers: it takes %d or a function of t", what, numel (joint.value), count);
  endif
endfunction

%!function scene = with (joint)
%!  scene = struct ("rod", struct ("length", 2), "joints", {{joint}});
%!endfunction
%!test # values are functions of t, and those that are no numbers are loads
%! [joints, loads] = joints_on_surface (with (struct ("kind", "force", "stations", 1, "value", [1; 2; 3])));
%! assert (joints.value ([5 6]), [1 2 3 1 2 3]); assert (isempty (loads)); assert (joints.point, [0 0 0]);
%! joints = joints_on_surface (with (struct ("kind", "force", "stations", 1, "value", @(t) [t; 2; 3])));
%! assert (joints.value ([5 6]), [5 2 3 6 2 3]);  # whether it returns rows or columns
%! [joints, loads] = joints_on_surface (with (struct ("kind", "moment", "stations", 1, "value", @(t) t)));
%! assert (joints.value (5), 5); assert (loads.name, "joints(1).value"); assert (loads.numbers, 1);
%!error <joints\(1\).kind is "slider": a rod on a surface takes "force", "moment" and "spring">
%! joints_on_surface (with (struct ("kind", "slider", "stations", 1)))
%!error <joints\(1\).stations are \[1 +2\]: it takes one station on the rod>
%! joints_on_surface (with (struct ("kind", "spring", "stations", [1 2])))
%!error <joints\(1\).stations is 3: it takes a place on the rod, from 0 to 2 m>
%! joints_on_surface (with (struct ("kind", "spring", "stations", 3)))
%!error <joints\(1\).bodies is \[2\]: there is one rod>
%! joints_on_surface (with (struct ("kind", "spring", "stations", 1, "bodies", 2)))
%!error <joints\(1\).point has 2 numbers: it takes \[x y z\] in m>
%! joints_on_surface (with (struct ("kind", "spring", "stations", 1, "point", [1 2])))
%!error <joints\(1\).value has 2 numbers: it takes 3 or a function of t>
%! joints_on_surface (with (struct ("kind", "force", "stations", 1, "value", [1 2])))
