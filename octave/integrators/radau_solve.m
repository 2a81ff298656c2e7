## -*- texinfo -*-
## @deftypefn {} {@var{x} =} radau_solve (@var{factors}, @var{i}, @var{r}, @var{tied})
## The @var{i}th of the matrices that @code{radau_factors} has factorised, under the columns of @var{r}: rows of q, v,
## lambda, mu and the springs' tensions, as @code{radau_matrix} has them; @var{tied}, where it is known, what they are
## off their constraints by, and mu.
## @end deftypefn

function x = radau_solve (factors, i, r, tied = off_constraints (factors, i, r))
  stage = factors.stages{i};
  [q, v, lambda, mu, sigma] = factors.parts{:};
  n = numel (q);
  d = tied(1:n,:)/stage.g;
  rest = stage.solve ([r(v,:) - factors.K*d; r(mu,:); r(sigma,:) + factors.stiff*d]);
  rates = rest(1:n,:);
  c = n + numel (lambda);
  x = [rates/stage.g + d; rates; rest(n+1:c,:); tied(n+1:end,:); rest(c+1:end,:)];
endfunction

function tied = off_constraints (factors, i, r)
  [q, ~, lambda, mu] = factors.parts{:};
  tied = factors.tie ([r(q,:); factors.stages{i}.g*factors.h*r(lambda,:) - r(mu,:)]);
endfunction

%!test # as the whole matrix does, for two panels with a joint and a spring each
%! rand ("seed", 3);
%! of = @(m, n) blkdiag (sparse (rand (m, n)), sparse (rand (m, n)));
%! M = of (3, 3) + 3*speye (6); K = of (3, 3); D = of (3, 3); J = of (1, 3); S = of (1, 3);
%! springs = struct ("stiffness", [7 8], "damping", [3 4]);
%! rule = radau_rule (3);
%! factors = radau_factors (rule, 0.5, M, K, D, J, S, springs, 2);
%! for i = 1:2
%!   r = rand (18, 2);
%!   matrix = radau_matrix (rule.eigenvalues(i)/0.5, 0.5, M, K, D, J, S, springs);
%!   assert (matrix*radau_solve (factors, i, r), r, 1e-12);
%! endfor
