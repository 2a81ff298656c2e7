## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_ode45 (@var{system}, @var{rate}, @var{times}, @var{y}, @var{tolerance})
## Dormand and Prince's method, Octave's @code{ode45}, through all @var{times} (1-by-m, s) from the state @var{y} (n-by-1).
##
## @var{rate} (t, y) is integrated as it is, or, where @var{system}.turned is true, in the form of @code{turned_form}, made
## anew at each of the @var{times} and at least 50 times in the duration.
## @var{tolerance} bounds a step's error in units of the state's scale.  Results: @var{states} (n-by-m), and the steps
## tried: a sixth of the calls, as the seventh stage is the first of the next step.
##
## An integration that does not reach the last time is an error that says where it stopped, and what to change.
## @end deftypefn

function [states, steps] = integrate_ode45 (system, rate, times, y, tolerance)
  if (! system.turned)
    [states, steps] = solve (rate, times, y, tolerance, system.state_scale, []);
    return;
  endif
  states = repmat (y, 1, numel (times));
  steps = 0;
  for k = 2:numel (times)
    pieces = ceil (50*(times(k) - times(k-1))/system.duration);
    ends = linspace (times(k-1), times(k), pieces + 1);
    for i = 1:pieces
      turned = turned_form (system, rate, ends(i), y);
      [u, taken] = solve (turned.rate, ends(i:i+1), turned.start, tolerance, turned.scale, diff (ends(i:i+1))/2);
      y = turned.state (ends(i+1), u(:,2));
      steps += taken;
    endfor
    states(:,k) = y;
  endfor
endfunction

function [states, steps] = solve (rate, times, y, tolerance, scale, first_step)
  ## with two times ode45 keeps every step, in arrays that it grows one by one
  requested = unique ([times, mean(times)]);
  options = odeset ("RelTol", max (tolerance, 100*eps), "AbsTol", max (tolerance*scale, realmin), ...
                    "InitialStep", first_step, "MaxStep", times(end) - times(1));
  before = watch_rate ("calls");
  warning_state = warning ("off", "all");
  unwind_protect
    [t, states] = ode45 (rate, requested, y, options);
  unwind_protect_cleanup
    warning (warning_state);
  end_unwind_protect
  steps = round ((watch_rate ("calls") - before)/6);
  finite = all (isfinite (states), 2);
  if (t(end) < times(end) || ! all (finite))
    scene_error (["ode45 stopped between t = %g s and %g s: its step size collapsed, because the state grows without" ...
                  " bound or the tolerance of %g m is below what doubles can hold; try a larger tolerance or fewer modes"],
                 max ([t(finite); times(1)]), times(end), tolerance);
  endif
  states = states(ismember (requested, times),:).';
endfunction

%!test # harmonic oscillator over ten periods, as it is and turned
%! system = struct ("mass", 1, "state_scale", [1; 1], "turned", false, "stiffness_at", @(t, y) 1, ...
%!                  "velocity_matrix", 1, "initial_state", [1; 0], "duration", 60);
%! for turned = [false, true]
%!   system.turned = turned;
%!   states = integrate_ode45 (system, @(t, y) [y(2); -y(1)], linspace (0, 20*pi, 11), [1; 0], 1e-10);
%!   assert (size (states), [2 11]);
%!   assert (states(:,end), [1; 0], 1e-7);
%! endfor
%!error <ode45 stopped between t = 0.9\d* s and 2 s: its step size collapsed>
%! integrate_ode45 (struct ("turned", false, "state_scale", 1), @(t, y) y^2, [0 0.9 0.99 2], 1, 1e-6);
