## -*- texinfo -*-
## @deftypefn {} {[@var{a}, @var{lambda}, @var{at}] =} accelerations (@var{system}, @var{t}, @var{q}, @var{v})
## Accelerations (n-by-1) and multipliers from M a + Phi_q' lambda = f and Phi'' = 0 in the state @var{q}, @var{v} at the time
## @var{t} (s), and all that was evaluated there (see @code{mechanism_system}).
## @end deftypefn

function [a, lambda, at] = accelerations (system, t, q, v, more = 0)
  at = system.at (t, q, v);
  [mass, jacobian] = system.matrices (at);
  [a, lambda] = saddle_solve (system, t, mass, jacobian, at.force, more - at.constraints.convection);
endfunction
