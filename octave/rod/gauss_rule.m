## -*- texinfo -*-
## @deftypefn {} {[@var{nodes}, @var{weights}] =} gauss_rule (@var{m})
## Gauss and Legendre's rule of @var{m} points (1-by-m) on 0 to 1, from the eigenvalues of the Jacobi matrix (Golub and
## Welsch, Math. Comput. 23, 1969).
## @end deftypefn

function [nodes, weights] = gauss_rule (m)
  k = 1:m-1;
  beside = k./sqrt (4*k.^2 - 1);
  [vectors, values] = eig (diag (beside, 1) + diag (beside, -1));
  [nodes, order] = sort (diag (values));
  nodes = (nodes.' + 1)/2;
  weights = vectors(1,order).^2;
endfunction

%!test # exact up to degree 2 m - 1
%! [nodes, weights] = gauss_rule (4);
%! assert (weights*nodes.'.^(0:7), 1./(1:8), 1e-14);
%! [nodes, weights] = gauss_rule (5);
%! assert (weights*nodes.'.^(0:9), 1./(1:10), 1e-14);
