## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{count}] =} integrate_constrained (@var{system}, @var{times}, @var{start}, @
##   @var{solver})
## What @code{integrate} makes of a mechanism's @var{system} from the state @var{start}, a struct of q, v, W and D;
## states have these names, too (see @code{named_rows}).
## @end deftypefn

function [states, count] = integrate_constrained (system, times, start, solver)
  start.lambda = zeros (system.constraint_count, 1);
  system.initial_state = stacked_rows (start);
  system.state_scale = system.q_scale;
  [states, count] = integrate (system, times, solver);
  states = named_rows (system, states);
endfunction

%!test # from its start, which stays in the first column
%! [system, start] = sample_mechanism ([0 0]);
%! states = integrate_constrained (system, [0 1e-3], start, struct ("name", "auto", "tolerance", 1e-6));
%! assert (states.q(:,1), start.q); assert (size (states.lambda), [system.constraint_count, 2]);
