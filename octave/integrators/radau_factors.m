## -*- texinfo -*-
## @deftypefn {} {@var{factors} =} radau_factors (@var{rule}, @var{h}, @var{M}, @var{K}, @var{D}, @var{J}, @var{S}, @
##   @var{springs}, @var{panels})
## The factorised matrices of Newton's iteration in @var{panels} of @var{h} (s; see @code{radau_window}): those of
## @code{radau_matrix}, which says what the others are, for the real eigenvalue of the @var{rule} and for one of each
## pair, all panels' blocks along the diagonals.
##
## A struct of stages and ties, as @code{radau_solve} takes them, ties_count, unit and compliance as
## @code{radau_matrix} has them, by_start (1-by-stages), what of a panel's start is in the rates at its stages, and
## transfer (2n-by-2n-by-panels), what a change of (q; v) at a panel's start does to its end.
##
## What positions are off their constraints by does not hang on the forces: with q = v/g + d the matrix [M J'; J 0]
## gives d and mu, and one of the size of the accelerations' equations the rest.
## @end deftypefn

function factors = radau_factors (rule, h, M, K, D, J, S, springs, panels)
  [~, unit, compliance] = radau_matrix (0, h, M, K, D, J, S, springs);
  c = rows (J);
  e = rows (S);
  diagonal = @(x) spdiags (x(:), 0, e, e);
  factors = struct ("h", h, "unit", unit, "compliance", compliance, "M", M, "K", K, "ties_count", c);
  factors.by_start = sum (rule.inverse, 2).'/h;
  factors.stiff = diagonal (compliance.*springs.stiffness)*S;
  factors.damped = diagonal (compliance.*springs.damping)*S;
  J *= unit;
  factors.ties = factorised ([M, J.'; J, sparse(c, c)]);
  into_eigenvectors = inv (rule.T).';
  for i = 1:(numel (rule.c) + 1)/2
    k = 2*i - 2 + (i == 1);
    g = rule.eigenvalues(k)/h;
    stage = factorised ([g*M + D + K/g, J.', unit*S.'
                         J, sparse(c, c + e)
                         -factors.stiff/g - factors.damped, sparse(e, c), unit*diagonal(compliance)]);
    stage.g = g;
    stage.onto = into_eigenvectors(:,k);
    stage.from = (1 + (i > 1))*rule.T(:,k).';  # with what the other of the pair has
    factors.stages{i} = stage;
  endfor
  factors.transfer = [];
  if (panels > 1)
    factors.transfer = transfer_matrices (factors, panels);
  endif
endfunction

function f = factorised (matrix)
  [f.L, f.U, f.rows, f.columns] = lu (matrix, "vector");
endfunction

function transfer = transfer_matrices (factors, panels)
  N = rows (factors.M);
  n = N/panels;
  starts = full (factors.M*repmat (speye (n), panels, 1));
  no_starts = 0*starts;
  none = @(m) zeros (m, 2*n);
  ends = 0;
  for i = 1:numel (factors.stages)
    by_start = factors.by_start*factors.stages{i}.onto;
    x = radau_solve (factors, i, {by_start*[starts, no_starts], by_start*[no_starts, starts], ...
                                  none(factors.ties_count), none(factors.ties_count), none(rows (factors.stiff))});
    ends += real (factors.stages{i}.from(end)*[x{1}; x{2}]);
  endfor
  transfer = reshape (permute (reshape (ends, n, panels, 2, 2*n), [1 3 4 2]), 2*n, 2*n, panels);
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
