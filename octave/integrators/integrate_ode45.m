## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps_per_call}] =} integrate_ode45 (@var{rate}, @var{times}, @var{y}, @var{tolerance}, @var{scale})
## Dormand and Prince's method, Octave's @code{ode45}, through all @var{times} (1-by-m, s) from the state @var{y} (n-by-1).
##
## @var{tolerance} bounds a step's error in units of @var{scale} (n-by-1).  Results: @var{states} (n-by-m), and the steps
## tried per call of @var{rate}: 1/6, as the seventh stage is the first of the next step.
##
## An integration that does not reach the last time is an error that says where it stopped, and what to change.
## @end deftypefn

function [states, steps_per_call] = integrate_ode45 (rate, times, y, tolerance, scale)
  steps_per_call = 1/6;
  ## with two times ode45 keeps every step, in arrays that it grows one by one
  requested = unique ([times, mean(times)]);
  options = odeset ("RelTol", max (tolerance, 100*eps), "AbsTol", max (tolerance*scale, realmin));
  warning_state = warning ("off", "all");
  unwind_protect
    [t, states] = ode45 (rate, requested, y, options);
  unwind_protect_cleanup
    warning (warning_state);
  end_unwind_protect
  finite = all (isfinite (states), 2);
  if (t(end) < times(end) || ! all (finite))
    scene_error (["ode45 stopped between t = %g s and %g s: its step size collapsed, because the state grows without" ...
                  " bound or the tolerance of %g m is below what doubles can hold; try a larger tolerance or fewer modes"],
                 max ([t(finite); times(1)]), times(end), tolerance);
  endif
  states = states(ismember (requested, times),:).';
endfunction

%!test # harmonic oscillator over ten periods
%! states = integrate_ode45 (@(t, y) [y(2); -y(1)], linspace (0, 20*pi, 11), [1; 0], 1e-10, [1; 1]);
%! assert (size (states), [2 11]);
%! assert (states(:,end), [1; 0], 1e-7);
%!error <ode45 stopped between t = 0.9\d* s and 2 s: its step size collapsed>
%! integrate_ode45 (@(t, y) y^2, [0 0.9 0.99 2], 1, 1e-6, 1);
