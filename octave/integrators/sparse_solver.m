## -*- texinfo -*-
## @deftypefn {} {@var{solve} =} sparse_solver (@var{matrix})
## The function @var{solve} (right_sides) of a sparse square @var{matrix}, which is factorised once.
## @end deftypefn

function solve = sparse_solver (matrix)
  [L, U, p, q] = lu (matrix, "vector");
  solve = @(right) solved (L, U, p, q, right);
endfunction

function x = solved (L, U, p, q, right)
  x(q,:) = U \ (L \ right(p,:));
endfunction

%!test
%! A = sparse ([0 2 1; 3 0 1; 1 1 0]);
%! solve = sparse_solver (A);
%! assert (A*solve ([1 2; 3 4; 5 6i]), [1 2; 3 4; 5 6i], 1e-14);
%!test # of none
%! assert (sparse_solver (sparse (0, 0)) (zeros (0, 3)), zeros (0, 3));
