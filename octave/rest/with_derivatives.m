## -*- texinfo -*-
## @deftypefn {} {@var{balance} =} with_derivatives (@var{balance}, @var{steps})
## A @var{balance} (see @code{mechanism_at_rest}) with its tangent and its damping, derivatives of its residual by
## differences of second order: coordinates change by the @var{steps} (n-by-1), and rates by as much a second.
## @end deftypefn

function balance = with_derivatives (balance, steps)
  balance.steps = steps;
  balance.tangent = @(t, q, lambda) tangent (balance, t, q, lambda);
  balance.damping = @(t, q, lambda) damping (balance, t, q, lambda);
endfunction

function D = tangent (balance, t, q, lambda)
  D = difference_quotients (@(x) balance.residual (t, q + x, 0*x, lambda), balance.steps);
  D(1:balance.n,:) *= -1;
endfunction

function C = damping (balance, t, q, lambda)
  C = -difference_quotients (@(x) balance.residual (t, q + 0*x, x, lambda), balance.steps)(1:balance.n,:);
endfunction

%!test # forces 2 - 3 q^2 - v t + lambda, and the constraint 5 q = 0
%! balance = struct ("n", 1, "residual", @(t, q, v, lambda) [2 - 3*q.^2 - t*v + lambda; 5*q]);
%! balance = with_derivatives (balance, 1e-4);
%! assert (balance.tangent (0, 7, 1), [42; 5], 1e-9); assert (balance.damping (4, 7, 1), 4, 1e-9);
