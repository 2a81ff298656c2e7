## -*- texinfo -*-
## @deftypefn {} {@var{motion} =} motion_of_group (@var{mechanism}, @var{group}, @var{q}, @var{v})
## The motion (see @code{motion_of_rods}) of the bodies of a marker @var{group} (see @code{list_markers}) in the states
## @var{q}, @var{v} (n-by-k) of a @var{mechanism}, body beside body, state after state.
## @end deftypefn

function motion = motion_of_group (mechanism, group, q, v)
  index = mechanism.groups(group.group).index(:,group.columns);
  motion = motion_of_rods (reshape (q(index,:), rows (index), []), reshape (v(index,:), rows (index), []));
endfunction

%!test
%! mechanism.groups.index = [1 5; 2 6; 3 7; 4 8];
%! motion = motion_of_group (mechanism, struct ("group", 1, "columns", [2 1]), [1:8; 11:18].', ones (8, 2));
%! assert (motion.V, [5 1 15 11]); assert (motion.y, [8 4 18 14]);
