## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_ode23s (@var{system}, @var{times}, @var{y}, @var{solver})
## Octave's @code{ode23s}, a Rosenbrock method of order 2 (Shampine and Reichelt, SIAM J. Sci. Comput. 18,
## 1997), through all @var{times} (1-by-m, s) from the state @var{y}, with @var{solver}.tolerance in units
## of the state's scale.
##
## The scale is the unit of what it integrates, since it takes one absolute tolerance for all.
## @var{steps}: Jacobian matrices, one a step, by finite differences.
## @end deftypefn

function [states, steps] = integrate_ode23s (system, times, y, solver)
  scale = system.state_scale;
  options = odeset ("RelTol", solver.tolerance, "AbsTol", solver.tolerance, "MaxStep", times(end) - times(1), ...
                    "InitialStep", min (1e-3*(times(end) - times(1)), 0.1/max (highest_frequency (system), realmin)));
  [states, steps] = octave_ode (@ode23s, system, @(t, u) system.rate (t, scale.*u)./scale, times, y./scale, options, ...
                                numel (y) + 4, solver.tolerance);
  states = scale.*states;
endfunction

%!test # a stiff oscillation, damped
%! system = struct ("mass", 1, "stiffness", 1, "state_scale", [1; 10], "rate", @(t, y) [y(2); -y(1)-100*y(2)], ...
%!                  "calls", @() 0);
%! states = integrate_ode23s (system, [0 1 2], [1; 0], struct ("tolerance", 1e-7));
%! roots = -50 + [1 -1]*sqrt (2499);
%! assert (states(1,3), (roots(1)*exp (2*roots(2)) - roots(2)*exp (2*roots(1)))/diff (-roots), 1e-5);
