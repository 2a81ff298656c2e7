## -*- texinfo -*-
## @deftypefn {} {@var{factors} =} radau_factors (@var{rule}, @var{h}, @var{M}, @var{K}, @var{D}, @var{J}, @var{S}, @
##   @var{springs})
## The factorised matrices of Newton's iteration in a step of @var{h} (s) of @code{radau_step}, one for the real
## eigenvalue of the @var{rule} and one for each pair: a struct of L, U, P, Q (cells), h, springs, and of rates, what
## the matrix has by each eigenvalue, unit (kg) and compliance (springs-by-1) of @code{radau_matrix}, which says what
## the others are.
## @end deftypefn

function factors = radau_factors (rule, h, M, K, D, J, S, springs)
  factors.h = h;
  factors.springs = springs;
  [~, factors.unit, factors.compliance] = radau_matrix (0, h, M, K, D, J, S, springs);
  for i = 1:(numel (rule.c) + 1)/2
    g = rule.eigenvalues(2*i - 2 + (i == 1))/h;
    matrix = radau_matrix (g, h, M, K, D, J, S, springs);
    [factors.L{i}, factors.U{i}, factors.P{i}, factors.Q{i}] = lu (matrix);
  endfor
  factors.rates = radau_matrix (1, h, M, K, D, J, S, springs) - radau_matrix (0, h, M, K, D, J, S, springs);
endfunction

%!test # a mass on a spring and damper: M (v' = g v) and what the spring does of it
%! rule = struct ("c", 1, "eigenvalues", 2);
%! springs = struct ("stiffness", 7, "damping", 3);
%! f = radau_factors (rule, 0.5, sparse (2), sparse (1), sparse (0), sparse (0, 1), sparse (1), springs);
%! x = f.Q{1}*(f.U{1} \ (f.L{1} \ (f.P{1}*[0; 1; 0])));
%! assert (x(3)*f.unit, 7*x(1) + 3*x(2), 1e-12);
%! assert (x(2), 4*x(1), 1e-12);
%! assert (x(1) + 8*x(2) + x(3)*f.unit, 1, 1e-12);
