## -*- texinfo -*-
## @deftypefn {} {[@var{system}, @var{q}, @var{v}, @var{h}] =} sample_state ()
## A state of @code{sample_mechanism}, near its start and with all velocities, and a step @var{h} for differences.
## @end deftypefn

function [system, q, v, h] = sample_state ()
  [system, start] = sample_mechanism ([1 2]);
  rand ("seed", 5);
  q = start.q + 0.01*rand (system.n, 1);
  v = 3*rand (system.n, 1) - 1;
  h = 1e-6;
endfunction

%!test # the same state at each call, off the constraints
%! [system, q, v] = sample_state ();
%! [~, same_q, same_v] = sample_state ();
%! assert (same_q, q); assert (same_v, v);
%! assert (norm (system.at (0, q, v).constraints.residual) > 1e-4);
