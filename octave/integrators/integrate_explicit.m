## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_explicit (@var{ode}, @var{system}, @var{times}, @var{y}, @
##   @var{solver})
## Octave's explicit Runge-Kutta methods, @var{ode} = @code{@@ode45} (Dormand and Prince) or @code{@@ode23} (Bogacki
## and Shampine), through all @var{times} (1-by-m, s) from the state @var{y} (n-by-1).
##
## system.rate (t, y) is integrated as it is, or, where there is a system.turned, true, in the form of
## @code{turned_form}, made anew at each of the @var{times} and at least 50 times in the duration.
## @var{solver}.tolerance bounds a step's error in units of the state's scale; with @var{solver}.step all steps have
## that length, whatever their error.  Results: @var{states} (n-by-m), and the steps tried: calls by the stages a step.
##
## An integration that does not reach the last time is an error that says where it stopped, and what to change.
## @end deftypefn

function [states, steps] = integrate_explicit (ode, system, times, y, solver)
  if (! (isfield (system, "turned") && system.turned))
    [states, steps] = solve (ode, system, system.rate, times, y, solver, system.state_scale, []);
    return;
  endif
  solver.tolerance *= 100;  # what rings is not followed
  states = repmat (y, 1, numel (times));
  steps = 0;
  for k = 2:numel (times)
    pieces = ceil (50*(times(k) - times(k-1))/system.duration);
    ends = linspace (times(k-1), times(k), pieces + 1);
    for i = 1:pieces
      turned = turned_form (system, ends(i), y);
      [u, taken] = solve (ode, system, turned.rate, ends(i:i+1), turned.start, solver, turned.scale, ...
                          diff (ends(i:i+1))/2);
      y = turned.state (ends(i+1), u(:,2));
      steps += taken;
    endfor
    states(:,k) = y;
  endfor
endfunction

function [states, steps] = solve (ode, system, rate, times, y, solver, scale, first_step)
  options = odeset ("RelTol", 100*eps, "AbsTol", max (solver.tolerance*scale, realmin), ...
                    "InitialStep", first_step, "MaxStep", times(end) - times(1));
  if (isfield (solver, "step") && ! isempty (solver.step))
    options = odeset ("RelTol", 1e100, "AbsTol", 1e100, "InitialStep", solver.step, "MaxStep", solver.step);
  endif
  stages = struct ("ode45", 6, "ode23", 3).(func2str (ode));
  [states, steps] = octave_ode (ode, system, rate, times, y, options, stages, solver.tolerance);
endfunction

%!test # harmonic oscillator over ten periods, as it is and turned
%! system = struct ("mass", 1, "state_scale", [1; 1], "turned", false, "stiffness", 1, "stiffness_at", @(t, y) 1, ...
%!                  "velocity_matrix", 1, "initial_state", [1; 0], "duration", 60, "rate", @(t, y) [y(2); -y(1)]);
%! system.calls = @() 0;
%! for turned = [false, true]
%!   system.turned = turned;
%!   for ode = {@ode45, @ode23}
%!     states = integrate_explicit (ode{1}, system, linspace (0, 20*pi, 11), [1; 0], struct ("tolerance", 1e-8/(1 + 99*turned)));
%!     assert (size (states), [2 11]);
%!     assert (states(:,end), [1; 0], 1e-5);
%!   endfor
%! endfor
%!test # equal steps: an error of order 5
%! system = struct ("state_scale", [1; 1], "rate", @(t, y) [y(2); -y(1)], "calls", @() 0);
%! error = @(h) norm (integrate_explicit (@ode45, system, [0 2], [1; 0], struct ("tolerance", 1, "step", h))(:,2) ...
%!                    - [cos(2); -sin(2)]);
%! assert (log2 (error (0.1)/error (0.05)), 5, 0.3);
%!error <ode45 stopped at t = 0.9\d* s of 2 s: its steps shrank to nothing>
%! system = struct ("turned", false, "state_scale", 1, "mass", 1, "stiffness", 0, "rate", @(t, y) y^2, ...
%!                  "calls", @() 0, "duration", 2);
%! integrate_explicit (@ode45, system, [0 0.9 0.99 2], 1, struct ("tolerance", 1e-6));
