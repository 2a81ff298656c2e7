## -*- texinfo -*-
## @deftypefn {} {[@var{d}, @var{q}, @var{v}] =} by_coordinates (@var{f}, @var{motion})
## The derivatives of @var{f} (motion), a number in each of k motions of a rod (see @code{motion_of_rods}), by its
## coordinates @var{q}, by differences (coordinates-by-k), for tests; @var{v} are the rates of these.
## @end deftypefn

function [d, q, v] = by_coordinates (f, motion)
  q = [motion.V; motion.phi; motion.x; motion.y];
  v = [motion.V_dot; motion.phi_dot; motion.x_dot; motion.y_dot];
  for j = 1:rows (q)
    step = 1e-5*((1:rows (q)).' == j);
    d(j,:) = (f (motion_of_rods (q + step, v)) - f (motion_of_rods (q - step, v)))/2e-5;
  endfor
endfunction

%!test
%! [d, q, v] = by_coordinates (@(m) m.phi.^2 + m.x, motion_of_rods ([7 7; 2 3; 0 0; 0 0], [1 1; 5 6; 0 0; 0 0]));
%! assert (d, [0 0; 4 6; 1 1; 0 0], 1e-9); assert (q(2,:), [2 3]); assert (v(2,:), [5 6]);
