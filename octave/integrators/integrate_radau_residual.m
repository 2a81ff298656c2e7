## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_radau_residual (@var{system}, @var{times}, @var{y}, @
##   @var{solver})
## Radau IIA of order 9 (see @code{radau_rule}) through all @var{times} (1-by-m, s) from the state @var{y} of a rod on
## a surface (see @code{surface_rod}): steps follow from the embedded formula of order 5, in @var{solver}.tolerance
## (m); frames are of the steps' polynomials.  Oscillations of stretching too fast for the steps die out.  Where another
## motion leads (see led_by of @code{kind_of}), or steps are shorter than the duration by 128, eight are solved at once,
## or fewer after some that failed.
## @end deftypefn

function [states, steps] = integrate_radau_residual (system, times, y, solver)
  persistent method = radau_method ();
  n = system.n;
  s = numel (method.points);
  states = repmat (y, 1, numel (times));
  t = times(1);
  h = 1e-2*system.duration;
  led = isfield (system, "led_states");
  if (led)
    h = system.led_step (solver.tolerance);
  endif
  a_start = -system.mass_matrix (y(1:n)) \ system.residual (t, y(1:n), y(n+1:2*n), zeros (n, 1));
  steps = refused = 0;
  at_once = 1 + 7*led;
  velocity = y(n+1:2*n);  # of the last steps, on the average: several that nothing leads are guessed to go on so
  patience = 1;
  alone = 0;  # so many steps are taken before several are again
  while (t < times(end))
    to_go = ceil ((times(end) - t)/h*(1 - 1e-9));
    h = min (h, (times(end) - t)/to_go);
    [a, starts] = deal (repmat (a_start, 1, s), y(1:2*n));
    if (at_once > 1)
      count = min (to_go, at_once);
      if (led)
        nodes = t + h*((0:count-1) + method.nodes);
        [a, starts] = guess_through (method, h, n, system.led_states (nodes(:).'));
      else
        [a, starts] = deal (zeros (n, s*count), [y(1:n) + velocity*h*(0:count-1); repmat(velocity, 1, count)]);
      endif
    endif
    count = columns (starts);
    [a, starts, stages, tangents, message] = collocation_stages (system, method, t, h, y, a, starts, ...
                                                                 1e-5*solver.tolerance);
    if (! isempty (message) && at_once > 1)
      [at_once, alone] = deal (1, patience);  # the guess leads astray
      patience = min (2*patience, 64);
      steps++;
      continue;
    endif
    growths = 0.5;
    if (isempty (message))
      off = embedded_errors (system, method, h, starts, [a_start, a(:,s:s:end)], stages, tangents);
      growths = max (0.1, 0.85*(off/solver.tolerance).^(-1/6));
      message = "its steps shrank to nothing";
    endif
    kept = find ([growths, 0] < 0.85, 1) - 1;
    steps += max (kept, 1);
    if (kept > 0)
      [starts, power] = states_with_work (system, method, t, h, starts, y(2*n+1:end), stages, a);
      inside = times > t & times <= t + kept*h*(1 + 1e-12);
      x = min (kept, (times(inside) - t)/h);
      states(:,inside) = within_step (method.points, h, starts, a, power, x);
      velocity = (starts(1:n,kept+1) - y(1:n))/(kept*h);
      y = starts(:,kept+1);
      t += kept*h;
      system.refuse_singular (starts(1:n,2:kept+1), sprintf ("at t = %.4g s", t));
      if (kept == to_go)
        t = times(end);
      endif
      a_start = a(:,s*kept);
      refused = 0;
    else
      refused++;
    endif
    if (kept == count)
      if (alone > 0)
        alone--;
      elseif (led || 128*h < system.duration)
        at_once = min (2*at_once, 8);
      else
        at_once = 1;
      endif
      h *= min ([growths, 1.5]);
    else
      h *= min (growths(kept+1), 0.8);
    endif
    if (h < 1e-10*system.duration || refused > 30)
      stop_integration ("radau", system, t, h, message, "a larger tolerance");
    endif
  endwhile
endfunction

function method = radau_method ()
  rule = radau_rule (5);
  method = struct ("points", rule.c.', "nodes", [0; rule.c.'], "A", rule.A, "AA", rule.A^2, "weights", rule.A(end,:), ...
                   "second_weights", rule.A(end,:)*rule.A, "e", rule.e, "g", real (rule.eigenvalues(1)));
endfunction

## of each step (1-by-steps, m), where the accelerations are so at all starts and the end; filtered, so that stiff modes
## count as what they will be
function metres = embedded_errors (system, method, h, starts, a, stages, tangents)
  n = system.n;
  s = numel (method.points);
  g = method.g/h;
  for k = 1:columns (a) - 1
    middle = s*(k - 1) + (s + 1)/2;
    [M, C, K] = deal (tangents.M(:,:,middle), tangents.C(:,:,middle), tangents.K(:,:,middle));
    [z, z_dot] = deal (starts(1:n,k), starts(n+1:2*n,k));
    of_step = s*(k - 1) + (1:s);
    place = z_dot + (stages{1}(:,of_step) - z)*method.e.'/h;
    rate = M*(a(:,k) + (stages{2}(:,of_step) - z_dot)*method.e.'/h);
    v = (g*M + C + K/g) \ (rate - K*place/g);
    metres(k) = max (system.size ((v + place)/g), h*system.size (v));
  endfor
endfunction

%!test # against ode45: a soft pendulum on a torus, frames within steps
%! scene = struct ("surface", struct ("name", "torus", "core_radius", 1, "tube_radius", 0.4), "duration", 0.3, ...
%!                 "rod", struct ("length", 0.5, "EA", 50, "EI", 0.1, "GJ", 0.3, "rhoA", 2), ...
%!                 "ends", {{"hinge", "free"}}, "model", struct ("modes", [4 4]), "initial", struct ("angle", 1), ...
%!                 "tip_moment", @(t) 0.3*sin (9*t));
%! scene.solver.tolerance = 1e-9;  # so that the start is as it is stated
%! system = surface_rod (check_surface_scene (scene));
%! times = 0:0.01:0.1;
%! states = integrate (system, times, struct ("name", "radau", "tolerance", 1e-8));
%! expected = integrate (system, times, struct ("name", "ode45", "tolerance", 1e-8));
%! assert (system.size (states(1:system.n,:) - expected(1:system.n,:)) < 1e-7);
%! assert (states(end,:), expected(end,:), 1e-7);
%!test # it takes its steps by the tolerance: of order 5 in what it estimates, and more in what it does
%! system = surface_rod (check_surface_scene (setfield (setfield (saddle (), "duration", 0.2), "model", "modes", [7 7])));
%! tip = @(tolerance) integrate (system, [0 0.2], struct ("name", "radau", "tolerance", tolerance))(1:system.n,2);
%! fine = tip (1e-10);
%! for tolerance = [1e-4 1e-6]
%!   assert (system.size (tip (tolerance) - fine) <= 4*tolerance);
%! endfor
%!test # where another motion leads astray it goes on alone
%! scene = check_surface_scene (setfield (setfield (saddle (), "duration", 0.2), "model", "modes", [5 5]));
%! system = surface_rod (scene);
%! solver = struct ("name", "radau", "tolerance", 1e-5);
%! [expected, alone] = integrate (system, [0 0.2], solver);
%! [system.led_states, system.led_step] = deal (@(t) 100*ones (2*system.n, numel (t)), @(tolerance) 0.2/alone.steps);
%! [states, count] = integrate (system, [0 0.2], solver);
%! assert (system.size (states(1:system.n,2) - expected(1:system.n,2)) < 1e-5);
%! assert (count.steps < 2*alone.steps + 3);
%!error <radau stopped at t = 0 s of 0.1 s: its loads or states are no numbers.* try a larger tolerance, fewer modes>
%! scene = struct ("surface", struct ("name", "cylinder", "radius", 1), "duration", 0.1, ...
%!                 "model", struct ("modes", [3 3]), "rod", struct ("length", 0.5, "EA", 50, "EI", 0.1, "rhoA", 2));
%! system = surface_rod (check_surface_scene (scene));
%! system.residual = @(t, z, varargin) NaN (size (z));
%! integrate (system, [0 0.1], struct ("name", "auto", "tolerance", 1e-9));
