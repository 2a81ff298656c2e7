## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} constrained_states (@var{method}, @var{system}, @var{times}, @var{y}, @
##   @var{solver})
## A method for mechanisms, [states, steps] = @var{method} (system, times, start, solver) with structs of q, v, lambda,
## W and D, for states in columns as @code{integrate} has them (see @code{named_rows}).
## @end deftypefn

function [states, steps] = constrained_states (method, system, times, y, solver)
  [reached, steps] = method (system, times, named_rows (system, y), solver);
  states = stacked_rows (reached);
endfunction

%!test # there and back
%! system = struct ("n", 1, "constraint_count", 2);
%! same = @(system, times, start, solver) deal (start, 3);
%! [states, steps] = constrained_states (same, system, 0, (1:6).', []);
%! assert (states, (1:6).'); assert (steps, 3);
