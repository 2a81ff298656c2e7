## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_exponential (@var{system}, @var{times}, @var{y}, @
##   @var{solver})
## Krogstad's exponential Runge-Kutta method of order 4 (J. Comput. Phys. 203, 2005) through all @var{times} (1-by-m,
## s) from the state @var{y}: the oscillation of the linear modes (see @code{modal_form}) is exact, what is left is
## taken at four stages.  The modes are those of the rod as it turns, made anew every second step.
##
## The first stage of the next step, and how the second difference of the stages changes from step to step, give an
## error estimate of order 3, which @var{solver}.tolerance bounds in units of system.state_scale.  The steps between
## two times are equal, as many as that takes, and none is longer than system.longest_step.  Steps that shrink to
## nothing are an error that says where.
## @end deftypefn

function [states, steps] = integrate_exponential (system, times, y, solver)
  n = rows (system.mass);
  scale = solver.tolerance*system.state_scale([1:n, 2*n+1:end]);
  states = repmat (y, 1, numel (times));
  steps = 0;
  h = diff (times([1 end]));
  curvature = [];
  age = 0;
  for k = 2:numel (times)
    t = times(k-1);
    while (t < times(k))
      if (age == 0)
        modal = modal_form (system, system.stiffness_at (t, y));
        z = modal.form (y);
        remainder = modal.remainder (t, z);
        step = struct ("h", 0);
      endif
      m = ceil ((times(k) - t)/min (h, system.longest_step)*(1 - 1e-9));
      if (abs ((times(k) - t)/m/step.h - 1) > 1e-9)
        step = exponential_step (modal.omega, modal.damping, (times(k) - t)/m, numel (y) - 2*n);
      endif
      [new_z, new_remainder, defect, new_curvature] = take_step (modal.remainder, t, z, remainder, step, curvature);
      steps++;
      error_ratio = max ([abs(modal.X)*max(defect(1:n), step.h*defect(n+1:2*n)); defect(2*n+1:end)]./scale);
      if (error_ratio <= 1)
        t += step.h;
        if (m == 1)
          t = times(k);
        endif
        z = new_z;
        y = modal.state (z);
        remainder = new_remainder;
        curvature = new_curvature;
        age = mod (age + 1, 2);
      endif
      next_h = step.h*next_factor (error_ratio);
      if (error_ratio <= 1 && m == 1)
        next_h = max (next_h, h);  # a step to the next time may have been a short one
      endif
      h = next_h;
      if (h < 1e-12*times(end))
        stop_integration ("exponential", system, t, h, "its steps shrank to nothing", ...
                          sprintf ("a larger tolerance than %.2g m", solver.tolerance));
      endif
    endwhile
    states(:,k) = y;
  endfor
endfunction

## A step's functions cost as much as a step: it changes only where that pays.
function factor = next_factor (error_ratio)
  factor = 0.2;
  if (isfinite (error_ratio))
    factor = min (max (0.9*error_ratio^(-1/4), 0.2), 3);
    if (factor > 0.9 && factor < 1.4)
      factor = 1;
    endif
  endif
endfunction

## curvature: the second derivative of the remainder in time, of the last step and of this one
function [z, R5, defect, curvature] = take_step (remainder, t, z, R1, step, last_curvature)
  half = step.half;
  whole = step.whole;
  h = step.h;
  swap = step.swap;
  middle = moved (half.free, z, swap) + moved (half.phi1, R1, swap);
  R2 = remainder (t + h/2, middle);
  R3 = remainder (t + h/2, middle + 2*moved (half.phi2, R2 - R1, swap));
  z = moved (whole.free, z, swap) + moved (whole.phi1, R1, swap);
  R4 = remainder (t + h, z + 2*moved (whole.phi2, R3 - R1, swap));
  second_difference = R1 - R2 - R3 + R4;
  z += moved (whole.phi2, 2*(R2 + R3) - 3*R1 - R4, swap) + 4*moved (whole.phi3, second_difference, swap);
  R5 = remainder (t + h, z);
  curvature = 4*second_difference/h^2;
  change = curvature;
  if (! isempty (last_curvature))
    change -= last_curvature;
  endif
  defect = h/6*(abs (R4 - R5) + h^2/16*abs (change));
endfunction

function z = moved (f, z, swap)
  z = f(:,1).*z + f(:,2).*z(swap);
endfunction

%!test # oscillations beyond the step are exact, the load is integrated to the tolerance
%! system = driven_oscillators ();
%! [states, steps] = integrate_exponential (system, [0 1 2.5 4], zeros (7, 1), struct ("tolerance", 1e-9));
%! w = [3; 1000];
%! exact = [1 - cos(4); (cos (4) - cos (4*w))./(w.^2 - 1)];
%! assert (states(1:3,4), exact, 1e-8);
%! assert (states(7,4), sin (4), 1e-8);
%! assert (steps < 1000);
%!error <exponential stopped at t = (0.99|1)\d* s of 2 s: its steps shrank to nothing: .* try a larger tolerance than 1e-06 m>
%! system = struct ("mass", 1, "stiffness", 0, "stiffness_at", @(t, y) 0, "longest_step", Inf, "duration", 2, ...
%!                  "state_scale", [1; 1], "velocity_matrix", 1, "initial_state", [1; 1]);
%! system.rate = @(t, y) [y(2); 2*y(1)^3];
%! integrate_exponential (system, [0 2], [1; 1], struct ("tolerance", 1e-6));
%!test # order 4 in equal steps, of a pendulum whose remainder depends on its state, and fewer steps than by order 3
%! system = struct ("mass", 1, "stiffness_at", @(t, y) 1, "state_scale", [1; 1], "velocity_matrix", 1, ...
%!                  "initial_state", [0; 0], "rate", @(t, y) [y(2,:); -sin(y(1,:))]);
%! k = 0.8;
%! exact = 2*asin (k*ellipj (4, k^2));
%! in_steps = @(h) integrate_exponential (setfield (system, "longest_step", h), [0 4], [0; 2*k], ...
%!                                        struct ("tolerance", 1))(1,2) - exact;
%! assert (log2 (in_steps (0.04)/in_steps (0.02)), 4, 0.2);
%! system.longest_step = Inf;
%! for k = 1:2
%!   [~, steps(k)] = integrate_exponential (system, [0 4], [0; 1.6], struct ("tolerance", [1e-5 1e-9](k)));
%! endfor
%! assert (steps(2)/steps(1) < 11);  # 1e4^(1/4), and a little
