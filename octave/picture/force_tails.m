## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}] =} force_tails (@var{drawing}, @var{size})
## Where the arrows of the forces of a @var{drawing} (see @code{draw_pictures}) begin (K-by-F, m): the largest one of
## all frames is six symbols of @var{size} (m) long.
## @end deftypefn

function [x, y] = force_tails (drawing, size)
  x = y = [];
  if (isfield (drawing, "forces"))
    forces = drawing.forces;
    metres = 6*size/max ([hypot(forces.F_x, forces.F_y)(:); realmin]);
    x = forces.x - metres*forces.F_x;
    y = forces.y - metres*forces.F_y;
  endif
endfunction

%!test
%! [x, y] = force_tails (struct ("forces", struct ("x", [1 2], "y", [3 4], "F_x", [0 3], "F_y", [0 -4])), 0.1);
%! assert (x, [1 2-0.36], 1e-12); assert (y, [3 4+0.48], 1e-12);
%! assert (force_tails (struct (), 1), []);
