## -*- texinfo -*-
## @deftypefn {} {@var{motion} =} motion_of_group (@var{group}, @var{q}, @var{v})
## The motion (see @code{motion_of_rods}) of the bodies of a @var{group}, of a mechanism's bodies or markers (see
## @code{build_mechanism}, @code{list_markers}), in its states @var{q}, @var{v} (n-by-k), body beside body, state after
## state.
## @end deftypefn

function motion = motion_of_group (group, q, v)
  R = rows (group.index);
  motion = motion_of_rods (reshape (q(group.index,:), R, []), reshape (v(group.index,:), R, []));
endfunction

%!test
%! motion = motion_of_group (struct ("index", [5 1; 6 2; 7 3; 8 4]), [1:8; 11:18].', ones (8, 2));
%! assert (motion.V, [5 1 15 11]); assert (motion.y, [8 4 18 14]);
