## -*- texinfo -*-
## @deftypefn {} {@var{numbers} =} constraint_coordinates (@var{form})
## Of which coordinates of its two markers, x, y, angle of the first and of the second, numbered 1 to 6, a scalar
## constraint is a function, by whose derivatives generated functions of the name @var{form} end.
## @end deftypefn

function numbers = constraint_coordinates (form)
  numbers = struct ("constraint_horizontal", [1 4], "constraint_vertical", [2 5], "constraint_angle", [3 6], ...
                    "constraint_line", [1 2 4 5 6], "constraint_distance", [1 2 4 5]).(form);
endfunction

%!test # as many as there are derivatives
%! for kind = joint_kinds ()
%!   for form = [kind.constraints, kind.springs]
%!     assert (nargout (form{1}), 2 + numel (constraint_coordinates (func2str (form{1}))));
%!   endfor
%! endfor
