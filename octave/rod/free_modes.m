## -*- texinfo -*-
## @deftypefn {} {[@var{X}, @var{squares}] =} free_modes (@var{stiffness}, @var{mass})
## The modes of free oscillation of a @var{stiffness} and a @var{mass} matrix (n-by-n, symmetric up to rounding): K*X =
## M*X*diag (@var{squares}), X (n-by-n, X.'*M*X = 1), squares of the frequencies (n-by-1, rad^2/s^2, increasing).
##
## Both are made symmetric to the last bit: where B.'*K*B has been rounded, @code{eig} would take the general way,
## which is many times slower and may return complex pairs.
## @end deftypefn

function [X, squares] = free_modes (stiffness, mass)
  halves = @(A) full (A + A.')/2;
  [X, squares] = eig (halves (stiffness), halves (mass));
  squares = reshape (real (diag (squares)), [], 1);
endfunction

%!test # matrices that rounding has made unsymmetric: real modes, orthonormal in the mass
%! rand ("seed", 3);
%! B = rand (12);
%! [K, M] = deal (B.'*diag (1:12)*B, B.'*B);
%! K(1,2) *= 1 + 4*eps;
%! [X, squares] = free_modes (K, M);
%! assert (squares, (1:12).', 1e-8);
%! assert (X.'*M*X, eye (12), 1e-8);
%!test # two equal frequencies, where the general way has complex pairs or none orthonormal
%! M = [2 1; 1 3];
%! K = 5*M; K(1,2) += eps;
%! [X, squares] = free_modes (K, M);
%! assert (isreal (X)); assert (X.'*M*X, eye (2), 1e-14); assert (squares, [5; 5], 1e-13);
%!assert (size (nthargout (2, @free_modes, [], [])), [0 1])
