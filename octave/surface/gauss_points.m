## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{weights}] =} gauss_points (@var{n})
## The @var{n} points and weights (n-by-1) of Gauss and Legendre on [0, 1], by the eigenvalues of the recurrence's
## matrix (Golub and Welsch, Math. Comp. 23, 1969).
## @end deftypefn

function [x, weights] = gauss_points (n)
  k = 1:n-1;
  beside = k./sqrt (4*k.^2 - 1);
  [vectors, values] = eig (diag (beside, 1) + diag (beside, -1));
  [x, order] = sort (diag (values));
  x = (x + 1)/2;
  weights = vectors(1,order).'.^2;
endfunction

%!test # exact to degree 2n - 1
%! [x, weights] = gauss_points (5);
%! for k = 0:9
%!   assert (weights.'*x.^k, 1/(k + 1), 1e-14);
%! endfor
