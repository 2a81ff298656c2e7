## -*- texinfo -*-
## @deftypefn {} {[@var{a}, @var{lambda}, @var{at}] =} constrained_accelerations (@var{system}, @var{t}, @var{q}, @
##   @var{v}, @var{correction})
## Accelerations (n-by-1) and multipliers from M a + Phi_q' lambda = f and Phi'' = @var{correction} (constraints), by
## default 0, in the state @var{q}, @var{v} at the time @var{t} (s), and all that was evaluated there (see
## @code{mechanism_system}).
## @end deftypefn

function [a, lambda, at] = constrained_accelerations (system, t, q, v, correction = @(constraints) 0)
  at = system.at (t, q, v);
  [mass, jacobian] = system.matrices (at);
  [a, lambda] = saddle_solve (system, t, mass, jacobian, at.force, ...
                              correction (at.constraints) - system.constraint_convection (at, v));
endfunction

%!test # they keep the constraints' second rates
%! [system, start] = sample_mechanism ([0 1]);
%! [a, lambda, at] = constrained_accelerations (system, 0.1, start.q, start.v);
%! [~, jacobian] = system.matrices (at);
%! assert (jacobian*a + system.constraint_convection (at, start.v), zeros (5, 1), 1e-9);
