## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_constrained_steps (@var{method}, @var{system}, @var{times}, @var{start}, @var{solver})
## A method of order 2 in equal steps through all @var{times}, by @code{integrate_fixed}: steps of @var{solver}.step, or
## halved until they meet @var{solver}.tolerance.
## @end deftypefn

function [states, steps] = integrate_constrained_steps (method, system, times, start, solver)
  ode = state_space (system);
  [reached, steps] = integrate_fixed (method, 2, ode, times, ode.pack (start), solver);
  states = first_states (system, times, start);
  for k = 1:numel (times)
    states = keep (states, k, ode.unpack (times(k), reached(:,k)));
  endfor
endfunction
