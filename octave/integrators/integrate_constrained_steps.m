## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_constrained_steps (@var{method}, @var{system}, @
##   @var{times}, @var{start}, @var{solver})
## A method of order 2 in equal steps through all @var{times}, by @code{integrate_fixed}: steps of @var{solver}.step,
## or halved until they meet @var{solver}.tolerance.
## @end deftypefn

function [states, steps] = integrate_constrained_steps (method, system, times, start, solver)
  ode = state_space (system);
  [reached, steps] = integrate_fixed (method, 2, ode, times, ode.pack (start), solver);
  states = ode.unpack (times, reached);
endfunction

%!test # order 2 of both methods
%! for name = {"generalized_alpha", "variational"}
%!   error = @(h) swing_pendulum (name{1}, [0 0.8], "step", h)(2) - pendulum_angle (0.8);
%!   assert (log2 (error (0.02)/error (0.01)), 2, 0.1);
%! endfor
