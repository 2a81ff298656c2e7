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
##
## Where another motion leads (see led_by of @code{kind_of}), eight frames are solved at once, or fewer after one that
## failed.
## @end deftypefn

function [states, steps] = integrate_gauss (system, times, y, solver)
  states = repmat (y, 1, numel (times));
  method = collocation (4);
  steps = 0;
  m = 2;
  largest = system.energy_floor;
  tangents = led = [];
  frames = times(are_frames (system, times));
  most = at_once = 1 + 7*isfield (system, "led_states");
  k = 1;
  while (k < numel (frames))
    ends = equal_steps (frames(k:min (k + at_once, end)));
    count = numel (ends) - 1;
    inside = times > ends(1) & times <= ends(end);
    frame = ends(2) - ends(1);
    tolerance = solver.tolerance*frame/system.duration;
    pieces = max (1, floor (m/2));
    if (isfield (system, "led_states"))
      led = system.led_states (step_times (ends, pieces, method.nodes));
    endif
    wanted = [ends(2:end), step_times(ends, 2*pieces, method.nodes)];
    coarse = collocation_steps (system, method, ends, y, pieces, [], wanted, led);
    do
      m = 2*pieces;
      if (m > 2^13)
        stop_integration ("gauss", system, ends(1), frame/m, "its steps shrank to nothing", ...
                          sprintf ("a larger tolerance than %.2g m", solver.tolerance));
      endif
      wanted = [ends(2:end), step_times(ends, 2*m, method.nodes), times(inside)];
      [fine, tangents] = collocation_steps (system, method, ends, y, m, tangents, wanted, coarse(:,count+1:end));
      steps += 3*pieces*count;
      [error, largest] = error_of (system, ends, [y, fine(:,1:count)], coarse(:,1:count), tolerance, largest);
      coarse = fine(:,1:end-nnz (inside));
      pieces = m;
    until (error <= tolerance || (isinf (error) && count > 1))
    if (isinf (error))
      at_once = 1;
      continue;
    endif
    if (error < tolerance/100 && m > 2)
      m /= 2;
    endif
    k += count;
    at_once = min (2*at_once, most);
    y = fine(:,count);
    system.refuse_singular (fine(1:system.n,1:count), sprintf ("at t = %.4g s", ends(end)));
    states(:,inside) = fine(:,end-nnz (inside)+1:end);
  endwhile
endfunction

## as many of the times as are equally far apart
function times = equal_steps (times)
  steps = diff (times);
  other = find (abs (steps - steps(1)) > 1e-9*steps(1), 1);
  times = times(1:min ([other, end]));
endfunction

## the nodes, parts of a step, of m steps between each two ends
function t = step_times (ends, m, nodes)
  t = ends(1:end-1) + (ends(2) - ends(1))/m*((0:m-1) + nodes)(:);
  t = t(:).';
endfunction

## the larger of what a frame adds to the error (m) and to the energy balance, in the same measure; and the largest
## change of an energy
function [error, largest] = error_of (system, ends, states, coarse, tolerance, largest)
  balance = 3e-9;
  n = system.n;
  change = states(:,2:end) - coarse;
  if (! all (isfinite (change(:))))
    error = Inf;
    return;
  endif
  added = arrayfun (@(k) system.size (change(1:n,k))/k, 1:columns (change));
  [drift, largest] = energy_drift (system, ends, states, largest);
  error = max (max (added)/16, tolerance*drift/balance);
endfunction

## how far the energy balance moves between two states, beyond rounding, as a part of the largest change of an energy
function [drift, largest] = energy_drift (system, times, states, largest)
  n = system.n;
  both = [states, system.initial_state];
  E = [system.energies([times, 0], both(1:n,:), both(n+1:2*n,:))(1:3,:); -both(2*n+1,:); both(2*n+2,:)];
  largest = max ([largest; max(abs (E(1:2,2:end-1)), [], 2); max(abs (E(3:5,2:end-1) - E(3:5,end)), [], 2)]);
  rounding = 100*eps*max (sum (abs (E), 1));
  drift = max (max (abs (diff (sum (E(:,1:end-1))))) - rounding, 0)/largest;
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
