## -*- texinfo -*-
## @deftypefn {} {@var{step} =} radau_whole_step (@var{system}, @var{rule}, @var{h}, @var{panels}, @var{at}, @var{x}, @
##   @var{residual})
## A step of Newton's iteration of @code{radau_window} with every stage's own matrix: what @code{radau_step} returns (a
## column each), where @var{x} has the unknowns and @var{at} what was evaluated there.
## @end deftypefn

function step = radau_whole_step (system, rule, h, panels, at, x, residual)
  s = numel (rule.c);
  from_start = sparse (1:s, s, sum (rule.inverse, 2), s, s);  # a panel starts with the last stage of the one before it
  before = spdiags (ones (panels, 1), -1, panels, panels);
  rates = kron (kron (rule.inverse, speye (panels)) - kron (from_start, before), speye (rows (x.q)))/h;
  [mass, jacobian, spring_jacobian] = system.matrices (at);
  matrix = radau_matrix (rates, h, mass, system.tangent (at, x.lambda, x.sigma), ...
                         kron (speye (panels*s), system.damping_matrix), jacobian, spring_jacobian, at.springs);
  right_side = vertcat (cellfun (@(r) r(:), residual, "uniformoutput", false){:});
  found = quietly (@() matrix \ right_side);
  step = mat2cell (found, cellfun (@numel, residual), 1);
endfunction

%!test # of two panels that hardly turn: as with a matrix each
%! [system, start] = sample_mechanism ([0 1]);
%! rule = radau_rule (3);
%! [q, v] = deal (repmat (start.q, 1, 6), repmat (start.v, 1, 6));
%! x = struct ("q", q, "lambda", zeros (system.constraint_count, 6));
%! x.sigma = zeros (system.mechanism.springs.count, 6);
%! at = system.at (zeros (1, 6), q, v);
%! middle = system.at ([0 0], q(:,1:2), v(:,1:2));
%! [M, J, S] = system.matrices (middle);
%! K = system.tangent (middle, x.lambda(:,1:2), x.sigma(:,1:2));
%! factors = radau_factors (rule, 0.01, M, K, kron (speye (2), system.damping_matrix), J, S, middle.springs, 2);
%! rand ("seed", 1);
%! residual = cellfun (@(m) rand (m, 6), {system.n; system.n; rows(J)/2; rows(J)/2; rows(S)/2}, "uniformoutput", false);
%! whole = radau_whole_step (system, rule, 0.01, 2, at, x, residual);
%! each = radau_step (factors, residual, 2);
%! for k = 1:5
%!   assert (whole{k}, each{k}(:), 1e-8*max (1, max (abs (whole{k}))));
%! endfor
