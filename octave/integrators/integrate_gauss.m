## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_gauss (@var{system}, @var{times}, @var{y}, @var{solver})
## Collocation at four points of Gauss through all @var{times} (1-by-m, s) from the state @var{y} of a rod on a surface
## (see @code{surface_rod}): order 8, symplectic in its canonical coordinates, stable for the stiffest bending and
## stretching.
##
## Between two frames (all @var{times}, or those of @var{system}.frames) as many equal steps are taken, doubled again
## and again, as bring a sixteenth of the last doubling's change of place (of which the last steps' error is 1/255 where
## they resolve the motion) within the interval's share of @var{solver}.tolerance (m), and the energy balance within
## 3e-9 of the largest energy, or of its floor system.energy_floor: a rod at rest has none to measure by.  Oscillations
## of stretching too fast for that keep their energy, not their phase.
## @end deftypefn

function [states, steps] = integrate_gauss (system, times, y, solver)
  states = repmat (y, 1, numel (times));
  method = collocation (4);
  balance = 3e-9;
  steps = 0;
  m = 2;
  n = system.n;
  largest = system.energy_floor;
  tangents = [];
  frames = times(are_frames (system, times));
  for k = 2:numel (frames)
    interval = frames([k-1, k]);
    inside = times > interval(1) & times <= interval(2);
    tolerance = solver.tolerance*diff (interval)/system.duration;
    pieces = max (1, floor (m/2));
    stages = @(m) interval(1) + diff (interval)/m*((0:m-1) + method.points)(:).';
    places = led_places (system, stages (pieces), interval(1), y);
    coarse = march (system, method, interval, y, pieces, [], [stages(2*pieces), interval(2)], places);
    places = coarse(1:n,1:end-1);  # where the first of the finer steps may begin to look
    coarse = coarse(:,end);
    do
      m = 2*pieces;
      if (m > 2^13)
        stop_integration ("gauss", system, interval(1), times(end), diff (interval)/m, ...
                          "its steps shrank to nothing", ...
                          sprintf ("a larger tolerance than %.2g m", solver.tolerance));
      endif
      [between, tangents] = march (system, method, interval, y, m, tangents, times(inside), places);
      fine = between(:,end);
      steps += 3*pieces;
      change = fine - coarse;
      [drift, largest] = energy_drift (system, interval, y, fine, largest);
      error = max (system.size (change(1:n))/16, tolerance*drift/balance);
      if (! all (isfinite (change)))
        error = Inf;
      endif
      coarse = fine;
      places = [];
      pieces = m;
    until (error <= tolerance)
    if (error < tolerance/100 && m > 2)
      m /= 2;
    endif
    y = fine;
    system.refuse_singular (y(1:n), sprintf ("at t = %.4g s", interval(2)));
    states(:,inside) = between;
  endfor
endfunction

## how far the energy balance moves between two states, beyond rounding, as a part of the largest change of an energy
function [drift, largest] = energy_drift (system, interval, before, after, largest)
  n = system.n;
  both = [before, after, system.initial_state];
  E = [system.energies([interval, 0], both(1:n,:), both(n+1:2*n,:))(1:3,:); -both(2*n+1,:); both(2*n+2,:)];
  largest = max ([largest; abs(E(1:2,2)); abs(E(3:5,2) - E(3:5,3))]);
  rounding = 100*eps*max (sum (abs (E), 1));
  drift = max (abs (sum (E(:,2)) - sum (E(:,1))) - rounding, 0)/largest;
endfunction

## m equal steps, and the states at some times of them, the last one the end; no numbers where Newton's iteration does
## not converge. Places of all stages are a first guess, where there are any.
function [states, tangents] = march (system, method, interval, y, m, tangents, times, places)
  states = NaN (rows (y), numel (times));
  h = diff (interval)/m;
  n = system.n;
  acceleration = zeros (n, 4);
  guessed = ! isempty (places) && all (isfinite (places(:)));
  for i = 1:m
    t = interval(1) + h*(i - 1);
    z = y(1:n);
    z_dot = y(n+1:2*n);
    if (guessed)
      acceleration = accelerations_to (method, h, z, z_dot, places(:,4*i-3:4*i));
    else
      acceleration *= method.onward.';
    endif
    [acceleration, stages, tangents, message] = collocation_stages (system, method, t, h, z, z_dot, acceleration, ...
                                                                    1e-12*system.points(end), tangents);
    if (! isempty (message))
      return;
    endif
    power = system.power (t + h*method.points.', stages{:}, acceleration);
    inside = times >= t & times < interval(1) + h*i;
    if (any (inside))
      states(:,inside) = within_step (method.points, h, y, acceleration, power, (times(inside) - t)/h);
    endif
    y = [z + h*z_dot + h^2*acceleration*method.second_weights.'; z_dot + h*acceleration*method.weights.'; ...
         y(2*n+1:end) + h*(power*method.weights.')];
  endfor
  states(:,end) = y;
endfunction

%!test # against ode45: a soft pendulum on a torus, and the energy
%! scene = struct ("surface", struct ("name", "torus", "core_radius", 1, "tube_radius", 0.4), "duration", 0.3, ...
%!                 "rod", struct ("length", 0.5, "EA", 50, "EI", 0.1, "GJ", 0.3, "rhoA", 2), ...
%!                 "ends", {{"hinge", "free"}}, "model", struct ("modes", [4 4]), "initial", struct ("angle", 1));
%! system = surface_rod (check_surface_scene (scene));
%! times = [0 0.1 0.2 0.3];
%! by = @(name, tolerance) integrate (system, times, struct ("name", name, "tolerance", tolerance));
%! states = by ("gauss", 3e-9);
%! expected = by ("ode45", 1e-8);
%! assert (states(1:system.n,:), expected(1:system.n,:), 1e-6);
%! n = system.n;
%! E = sum (surface_energies (system, times, states(1:n,:), states(n+1:2*n,:))(1:3,:));
%! assert (E, E(1)*[1 1 1 1], 1e-9);
%! system.frames = times;  # between them: the same motion, at no more calls
%! finer = 0:0.02:0.3;
%! [dense, count] = integrate (system, finer, struct ("name", "gauss", "tolerance", 3e-9));
%! [~, frames_count] = integrate (system, times, struct ("name", "gauss", "tolerance", 3e-9));
%! assert (count.calls, frames_count.calls); assert (dense(:,1:5:end), states, 1e-12);
%! alone = integrate (rmfield (system, "frames"), finer, struct ("name", "gauss", "tolerance", 3e-9));
%! assert (dense(1:n,:), alone(1:n,:), 1e-5);
%!test # at rest on a level plane and hanging at its place, it takes two steps a frame
%! for inclination = [0, pi/2]
%!   scene = struct ("surface", struct ("name", "plane", "inclination", inclination, "side", 0), "duration", 2, ...
%!                   "rod", struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 3), "ends", {{"hinge", "free"}}, ...
%!                   "gravity", 9.81*(inclination == 0), "initial", struct ("angle", -pi/2), ...
%!                   "model", struct ("modes", [4 4]));
%!   system = surface_rod (check_surface_scene (scene));
%!   [states, count] = integrate (system, 0:0.1:2, struct ("name", "gauss", "tolerance", 1e-4));
%!   assert (system.size (states(1:system.n,:)) < 1e-12);
%!   assert (count.steps <= 70);
%! endfor
%!test # a hundred kilometres up, what energies of 3 MJ lose by rounding is no drift
%! scene = struct ("surface", struct ("name", "plane", "inclination", pi/2, "side", 0), "duration", 0.02, ...
%!                 "rod", struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 3), "ends", {{"hinge", "free"}}, ...
%!                 "initial", struct ("angle", -pi/2, "point", [0 1e5]), "model", struct ("modes", [4 4]));
%! [~, count] = integrate (surface_rod (check_surface_scene (scene)), 0:0.01:0.02, ...
%!                         struct ("name", "gauss", "tolerance", 1e-4));
%! assert (count.steps < 1000);
%!error <gauss stopped at t = 0(.0*)? s of 0.1 s: its steps shrank to nothing.* try a larger tolerance than 1e-09 m>
%! scene = struct ("surface", struct ("name", "cylinder", "radius", 1), "duration", 0.1, ...
%!                 "model", struct ("modes", [3 3]), "rod", struct ("length", 0.5, "EA", 50, "EI", 0.1, "rhoA", 2));
%! system = surface_rod (check_surface_scene (scene));
%! system.residual = @(t, z, varargin) NaN (size (z));
%! integrate (system, [0 0.1], struct ("name", "gauss", "tolerance", 1e-9));
