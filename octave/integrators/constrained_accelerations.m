## -*- texinfo -*-
## @deftypefn {} {[@var{a}, @var{lambda}, @var{at}] =} constrained_accelerations (@var{system}, @var{t}, @var{q}, @
##   @var{v}, @var{correction})
## Accelerations (n-by-k) and multipliers from M a + Phi_q' lambda = f and Phi'' = @var{correction} (constraints), by
## default 0, in the states @var{q}, @var{v} (n-by-k) at the times @var{t} (1-by-k, s), and all that was evaluated
## there (see @code{mechanism_system}).
## @end deftypefn

function [a, lambda, at] = constrained_accelerations (system, t, q, v, correction = @(constraints) 0)
  at = system.at (t, q, v);
  [mass, jacobian] = system.matrices (at);
  bent = correction (at.constraints) - system.constraint_convection (at, v);
  c = rows (jacobian)/columns (q);
  n = rows (q);
  for k = 1:columns (q)
    own = (k - 1)*n + (1:n);
    ties = (k - 1)*c + (1:c);
    [a(:,k), lambda(:,k)] = saddle_solve (system, t(k), mass(own,own), jacobian(ties,own), at.force(:,k), bent(:,k));
  endfor
endfunction

%!test # they keep the constraints' second rates
%! [system, start] = sample_mechanism ([0 1]);
%! [a, lambda, at] = constrained_accelerations (system, 0.1, start.q, start.v);
%! [~, jacobian] = system.matrices (at);
%! assert (jacobian*a + system.constraint_convection (at, start.v), zeros (5, 1), 1e-9);
%! [both, tensions] = constrained_accelerations (system, [0.2 0.1], start.q*[1 1], [0*start.v, start.v]);
%! assert (both(:,2), a, 1e-12*norm (a)); assert (tensions(:,2), lambda, 1e-12*norm (lambda));
