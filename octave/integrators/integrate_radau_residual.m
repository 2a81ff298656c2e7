## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_radau_residual (@var{system}, @var{times}, @var{y}, @
##   @var{solver})
## Radau IIA of order 9 (see @code{radau_rule}) through all @var{times} (1-by-m, s) from the state @var{y} of a rod on
## a surface (see @code{surface_rod}): steps follow from the embedded formula of order 5, in @var{solver}.tolerance
## (m); frames are of the steps' polynomials.  Oscillations of stretching too fast for the steps die out.
## @end deftypefn

function [states, steps] = integrate_radau_residual (system, times, y, solver)
  persistent method = radau_method ();
  n = system.n;
  states = repmat (y, 1, numel (times));
  t = times(1);
  h = 1e-2*system.duration;
  if (isfield (system, "led_states"))
    h = system.led_step (solver.tolerance);
  endif
  a_start = -system.mass_matrix (y(1:n)) \ system.residual (t, y(1:n), y(n+1:2*n), zeros (n, 1));
  steps = refused = 0;
  while (t < times(end))
    to_go = ceil ((times(end) - t)/h*(1 - 1e-9));
    h = min (h, (times(end) - t)/to_go);
    if (isfield (system, "led_states") && ! refused)
      [a, start] = guess_through (method, h, n, system.led_states (t + h*[0, method.points.']));
    else
      [a, start] = deal (repmat (a_start, 1, numel (method.points)), y(1:2*n));
    endif
    [a, ~, stages, tangents, message] = collocation_stages (system, method, t, h, y, a, start, 1e-5*solver.tolerance);
    steps++;
    growth = 0.5;
    if (isempty (message))
      ratio = embedded_error (system, method, h, y, a_start, stages, tangents)/solver.tolerance;
      growth = max (0.1, 0.85*ratio^(-1/6));
      message = "its steps shrank to nothing";
    endif
    if (growth >= 0.85)
      power = system.power (t + h*method.points.', stages{:}, a);
      inside = times > t & times <= t + h*(1 + 1e-12);
      reached = within_step (method.points, h, y, a, power, [min(1, (times(inside) - t)/h), 1]);
      states(:,inside) = reached(:,1:end-1);
      y = reached(:,end);
      t += h;
      system.refuse_singular (y(1:n), sprintf ("at t = %.4g s", t));
      if (to_go == 1)
        t = times(end);
      endif
      a_start = a(:,end);
      growth = min (growth, 1.5);
      refused = 0;
    else
      growth = min (growth, 0.8);
      refused++;
    endif
    h *= growth;
    if (h < 1e-10*system.duration || refused > 30)
      stop_integration ("radau", system, t, times(end), h, message, "a larger tolerance");
    endif
  endwhile
endfunction

function method = radau_method ()
  rule = radau_rule (5);
  method = struct ("points", rule.c.', "A", rule.A, "AA", rule.A^2, "weights", rule.A(end,:), ...
                   "second_weights", rule.A(end,:)*rule.A, "e", rule.e, "g", real (rule.eigenvalues(1)));
endfunction

## in metres; filtered, so that stiff modes count as what they will be
function metres = embedded_error (system, method, h, y, a_start, stages, tangents)
  n = system.n;
  middle = (numel (method.points) + 1)/2;
  [M, C, K] = deal (tangents.M(:,:,middle), tangents.C(:,:,middle), tangents.K(:,:,middle));
  g = method.g/h;
  place = y(n+1:2*n) + (stages{1} - y(1:n))*method.e.'/h;
  rate = M*(a_start + (stages{2} - y(n+1:2*n))*method.e.'/h);
  v = (g*M + C + K/g) \ (rate - K*place/g);
  metres = max (system.size ((v + place)/g), h*system.size (v));
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
%! scene = check_surface_scene (setfield (setfield (saddle (), "duration", 0.2), "model", "modes", [7 7]));
%! system = surface_rod (scene);
%! tip = @(tolerance) integrate (system, [0 0.2], struct ("name", "radau", "tolerance", tolerance))(1:system.n,2);
%! fine = tip (1e-10);
%! for tolerance = [1e-4 1e-6]
%!   assert (system.size (tip (tolerance) - fine) <= 4*tolerance);
%! endfor
%!error <radau stopped at t = 0 s of 0.1 s: its loads or states are no numbers.* try a larger tolerance, fewer modes>
%! scene = struct ("surface", struct ("name", "cylinder", "radius", 1), "duration", 0.1, ...
%!                 "model", struct ("modes", [3 3]), "rod", struct ("length", 0.5, "EA", 50, "EI", 0.1, "rhoA", 2));
%! system = surface_rod (check_surface_scene (scene));
%! system.residual = @(t, z, varargin) NaN (size (z));
%! integrate (system, [0 0.1], struct ("name", "auto", "tolerance", 1e-9));
