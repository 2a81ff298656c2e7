## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_fixed (@var{method}, @var{order}, @var{system}, @
##   @var{times}, @var{y}, @var{solver})
## A method of equal steps through all @var{times} (1-by-m, s) from the state @var{y}: steps of @var{solver}.step (s),
## or a little shorter, so that they meet the times.  Without a step, it is shortened until an error by the method's
## @var{order}, from the last two runs, is within @var{solver}.tolerance in units of the state's scale.
##
## @var{method} (system, h, solver) is a struct of form (y) = z, step (t, z) = [z, converged] and state (z) = y.  A
## state that is no number, a Newton iteration that does not converge, or more than 1e8 steps are errors.
## @end deftypefn

function [states, steps] = integrate_fixed (method, order, system, times, y, solver)
  if (isfield (solver, "step") && ! isempty (solver.step))
    [states, steps] = march (method, system, times, y, solver, solver.step);
    return;
  endif
  n = rows (system.mass);
  omega = highest_frequency (system);
  h = min ((times(end) - times(1))/100, min (0.8*stability_limit (solver.name), 20)/max (omega, realmin));
  [states, steps] = march (method, system, times, y, solver, h);
  do
    coarse = states;
    h /= 2;
    [states, taken] = march (method, system, times, y, solver, h);
    steps += taken;
    off = max (max (abs (states - coarse)(1:n,:), [], 2)./system.state_scale(1:n))/(2^order - 1);
  until (off <= solver.tolerance)
endfunction

function [states, steps] = march (method, system, times, y, solver, h)
  name = solver.name;
  needed = sum (ceil (diff (times)/h*(1 - 1e-9)));
  if (needed > 1e8)
    what = sprintf ("it would take %.2g steps, more than 1e8", needed);
    stop_integration (name, system, times(1), h, what, "a longer step or a larger tolerance");
  endif
  states = repmat (y, 1, numel (times));
  steps = 0;
  made_for = NaN;
  for k = 2:numel (times)
    m = ceil ((times(k) - times(k-1))/h*(1 - 1e-9));
    length = (times(k) - times(k-1))/m;
    if (! (abs (length/made_for - 1) < 1e-9))
      stepper = method (system, length, solver);
      made_for = length;
      z = stepper.form (y);
    endif
    for i = 0:m-1
      [z, converged] = stepper.step (times(k-1) + i*length, z);
      if (! converged)
        stop_integration (name, system, times(k-1) + i*length, length, ...
                          "its Newton iteration did not converge", "a shorter step");
      endif
    endfor
    y = stepper.state (z);
    if (! all (isfinite (y)))
      stop_integration (name, system, times(k-1), length, "then its state is no number", "a shorter step");
    endif
    states(:,k) = y;
    steps += m;
  endfor
endfunction

%!test # the step follows from the tolerance, or is the given one
%! [scene, model] = sample_rod ([0 1], "duration", 0.1);
%! system = hinged_rod (scene, model);
%! solver = struct ("name", "auto", "tolerance", 1e-8, "step", [], "rho_infinity", 0.8);
%! reference = integrate (system, [0 0.05 0.1], solver);
%! solver.tolerance = 1e-5;
%! for name = {"rk4", "stormer_verlet", "implicit_midpoint", "generalized_alpha", "trigonometric"}
%!   solver.name = name{1};
%!   assert (integrate (system, [0 0.05 0.1], solver)(1:2,:), reference(1:2,:), 1e-5);
%! endfor
%! solver.name = "rk4"; solver.step = 0.001;
%! [~, count] = integrate (system, [0 0.05 0.1], solver);
%! assert (count.steps, 100);
%! assert (count.calls, 400);
%!error <rk4 stopped at t = 0 s of 1 s: it would take 1e\+09 steps, more than 1e8: .*; try steps below 0.028 s, a longer>
%! system = struct ("mass", 1, "stiffness", 1e4, "duration", 1);
%! integrate_fixed (@rk4, 4, system, [0 1], [1; 0], struct ("name", "rk4", "step", 1e-9));
%!error <rk4 stopped at t = \d.* s of 20 s: then its state is no number: a step of 0.1 s .* is 10 where .* stable below 2.828>
%! system = struct ("mass", 1, "stiffness", 1e4, "duration", 20, "rate", @(t, y) [y(2); -1e4*y(1)]);
%! integrate_fixed (@rk4, 4, system, 0:20, [1; 0], struct ("name", "rk4", "step", 0.1));
