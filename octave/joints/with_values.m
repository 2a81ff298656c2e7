## -*- texinfo -*-
## @deftypefn {} {@var{joints} =} with_values (@var{joints}, @var{of_bodies})
## The checked @var{joints} between bodies (see @code{check_joints}) with values that are functions of t (see
## @code{joint_value}).
## @end deftypefn

function joints = with_values (joints, of_bodies)
  for k = 1:numel (joints)
    joints(k).value = joint_value (joints(k), joints(k).value_name, of_bodies);
  endfor
endfunction

%!test
%! body = struct ("rod", struct ("length", 1, "curvature", []), "initial", struct ("phi", 0));
%! joint = struct ("kind", "force", "bodies", 1, "stations", 0.5, "value", [1 2]);
%! joints = with_values (check_joints ({joint, joint}, body), body);
%! assert (joints(2).value (3), [1 2]);
