## -*- texinfo -*-
## @deftypefn {} {@var{x} =} radau_solve (@var{factors}, @var{i}, @var{r})
## The @var{i}th of the matrices that @code{radau_factors} has factorised, under @var{r}: both are cells of the parts
## that belong to q, v, lambda, mu and the springs' tensions (as @code{radau_matrix} has them), whose columns are
## solved for.
## @end deftypefn

function x = radau_solve (factors, i, r)
  stage = factors.stages{i};
  n = rows (factors.M);
  ties = solved (factors.ties, [r{1}; stage.g*factors.h*r{3} - r{4}]);
  d = ties(1:n,:)/stage.g;
  rest = solved (stage, [r{2} - factors.K*d; r{4}; r{5} + factors.stiff*d]);
  v = rest(1:n,:);
  c = rows (r{3});
  x = {v/stage.g + d, v, rest(n+1:n+c,:), ties(n+1:end,:), rest(n+c+1:end,:)};
endfunction

function x = solved (f, right)
  x(f.columns,:) = f.U \ (f.L \ right(f.rows,:));
endfunction

%!test # as the whole matrix does, for two panels with a joint and a spring each
%! rand ("seed", 3);
%! of = @(m, n) blkdiag (sparse (rand (m, n)), sparse (rand (m, n)));
%! M = of (3, 3) + 3*speye (6); K = of (3, 3); D = of (3, 3); J = of (1, 3); S = of (1, 3);
%! springs = struct ("stiffness", [7 8], "damping", [3 4]);
%! rule = radau_rule (3);
%! factors = radau_factors (rule, 0.5, M, K, D, J, S, springs, 2);
%! for i = 1:2
%!   r = {rand(6, 2), rand(6, 2), rand(2, 2), rand(2, 2), rand(2, 2)};
%!   x = radau_solve (factors, i, r);
%!   matrix = radau_matrix (rule.eigenvalues(i)/0.5, 0.5, M, K, D, J, S, springs);
%!   assert (matrix*vertcat (x{:}), vertcat (r{:}), 1e-12);
%! endfor
