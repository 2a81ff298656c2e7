## -*- texinfo -*-
## @deftypefn {} {@var{factors} =} radau_factors (@var{rule}, @var{h}, @var{M}, @var{K}, @var{D}, @var{J}, @var{S}, @
##   @var{springs}, @var{panels})
## The factorised matrices of Newton's iteration in @var{panels} of @var{h} (s; see @code{radau_window}): those of
## @code{radau_matrix}, which says what the others are, for the real eigenvalue of the @var{rule} and for one of each
## pair, all panels' blocks along the diagonals.
##
## A struct of stages and tie, as @code{radau_solve} takes them, parts (which rows belong to q, v, lambda, mu and the
## tensions, a cell each), unit and compliance as @code{radau_matrix} has them; for several panels also transfer
## (2n-by-2n-by-panels), what a change of (q; v) at a panel's start does to its end, and in the stages by_start
## (rows-by-2n), what it does there.
##
## What positions are off their constraints by does not hang on the forces: with q = v/g + d the matrix [M J'; J 0]
## gives d and mu, and one of the size of the accelerations' equations the rest.
## @end deftypefn

function factors = radau_factors (rule, h, M, K, D, J, S, springs, panels)
  [~, unit, compliance] = radau_matrix (0, h, M, K, D, J, S, springs);
  n = rows (M);
  c = rows (J);
  e = rows (S);
  diagonal = @(x) spdiags (x(:), 0, e, e);
  factors = struct ("h", h, "unit", unit, "compliance", compliance, "M", M, "K", K);
  factors.parts = mat2cell (1:2*(n + c) + e, 1, [n n c c e]);
  factors.stiff = diagonal (compliance.*springs.stiffness)*S;
  damped = diagonal (compliance.*springs.damping)*S;
  J *= unit;
  factors.tie = sparse_solver ([M, J.'; J, sparse(c, c)]);
  into_eigenvectors = inv (rule.T).';
  for i = 1:(numel (rule.c) + 1)/2
    k = 2*i - 2 + (i == 1);
    stage.g = rule.eigenvalues(k)/h;
    stage.solve = sparse_solver ([stage.g*M + D + K/stage.g, J.', unit*S.'
                                  J, sparse(c, c + e)
                                  -factors.stiff/stage.g - damped, sparse(e, c), unit*diagonal(compliance)]);
    stage.onto = into_eigenvectors(:,k);
    stage.from = (1 + (i > 1))*rule.T(:,k).';  # with what the other of the pair has
    factors.stages{i} = stage;
  endfor
  if (panels > 1)
    factors = with_starts (factors, panels, sum (rule.inverse, 2).'/h);
  endif
endfunction

## panels' starts are in the rates at their stages by these weights
function factors = with_starts (factors, panels, weights)
  [q, v, ~, mu] = factors.parts{:};
  n = numel (q)/panels;
  right = zeros (sum (cellfun (@numel, factors.parts)), 2*n);
  right(q,1:n) = right(v,n+1:end) = full (factors.M*repmat (speye (n), panels, 1));
  tied = [factors.tie(right([q, mu],1:n)), zeros(numel ([q, mu]), n)];
  ends = 0;
  for i = 1:numel (factors.stages)
    by = weights*factors.stages{i}.onto;
    factors.stages{i}.by_start = by*radau_solve (factors, i, right, tied);
    ends += real (factors.stages{i}.from(end)*factors.stages{i}.by_start([q, v],:));
  endfor
  factors.transfer = reshape (permute (reshape (ends, n, panels, 2, 2*n), [1 3 4 2]), 2*n, 2*n, panels);
endfunction

%!test # a free mass goes on from where it starts, and one on a stiff spring and damper is back at its place at once
%! rule = radau_rule (3);
%! none = sparse (0, 2);
%! springs = struct ("stiffness", zeros (0, 2), "damping", zeros (0, 2));
%! factors = radau_factors (rule, 0.5, 2*speye (2), sparse (2, 2), sparse (2, 2), none, none, springs, 2);
%! assert (factors.transfer, repmat ([1 0.5; 0 1], [1 1 2]), 1e-14);
%! springs = struct ("stiffness", [1e12 0], "damping", [1 0]);
%! factors = radau_factors (rule, 0.5, 2*speye (2), sparse (2, 2), sparse (2, 2), none, speye (2), springs, 2);
%! assert (factors.transfer(1,:,1), [0 0], 1e-9);
%! assert (factors.transfer(:,:,2), [1 0.5; 0 1], 1e-13);
