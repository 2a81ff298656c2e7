## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_ode15s (@var{system}, @var{times}, @var{y}, @var{solver})
## Octave's @code{ode15s}, the variable-order BDF of SUNDIALS' IDA, through all @var{times} (1-by-m, s) from the state
## @var{y}, with @var{solver}.tolerance in units of the state's scale.  It is given the initial slope, which it takes
## for 0 otherwise.  @var{steps} is not known: NaN.
## @end deftypefn

function [states, steps] = integrate_ode15s (system, times, y, solver)
  steps = NaN;
  requested = unique ([times, mean(times)]);
  absolute = max (solver.tolerance*system.state_scale, realmin);
  options = odeset ("RelTol", max (solver.tolerance, 100*eps), "AbsTol", absolute, ...
                    "InitialSlope", system.rate (times(1), y), "MaxStep", times(end) - times(1));
  cause = "its Newton iteration did not converge";
  try
    [t, states] = quietly (@() told_errors (@(f) ode15s (@(t, u) f (t, u), requested, y, options), system.rate));
  catch err
    if (isempty (strfind (err.message, "IDA")))
      rethrow (err);
    endif
    t = times(1);
    states = y.';
    cause = "IDA gave up, at its step limit or at its smallest step";
  end_try_catch
  finite = all (isfinite (states), 2);
  if (t(end) < times(end) || ! all (finite))
    reached = max ([t(finite); times(1)]);
    stop_integration ("ode15s", system, reached, NaN, cause, ...
                      sprintf ("a larger tolerance than %.2g m", solver.tolerance));
  endif
  states = states(ismember (requested, times),:).';
endfunction

%!testif HAVE_SUNDIALS # a stiff oscillation, damped, that does not start at rest
%! system = struct ("mass", 1, "stiffness", 1, "state_scale", [1; 1], "rate", @(t, y) [y(2); -y(1)-100*y(2)]);
%! states = integrate_ode15s (system, [0 1 2], [1; 0], struct ("tolerance", 1e-8));
%! roots = -50 + [1 -1]*sqrt (2499);
%! assert (states(1,3), (roots(1)*exp (2*roots(2)) - roots(2)*exp (2*roots(1)))/diff (-roots), 1e-5);
%!testif HAVE_SUNDIALS
%! system = struct ("mass", 1, "stiffness", 0, "state_scale", 1, "duration", 2, "rate", @(t, y) y^2);
%! run = @() integrate_ode15s (system, [0 1 2], 1, struct ("tolerance", 1e-8));
%! fail ("run ()", "ode15s stopped at t = 0 s of 2 s: I(DA gave|ts Newton)");
