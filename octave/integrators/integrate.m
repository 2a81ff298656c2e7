## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{count}] =} integrate (@var{system}, @var{times}, @var{solver})
## The states (n-by-m) of a system (see @code{hinged_rod}) at the @var{times} (1-by-m, s, from the start of the
## motion), by the method @var{solver}.name of @code{integrator_table} with @var{solver}.tolerance (m), or with steps
## of @var{solver}.step (s) where the method's steps are equal; "auto" is "waveform".
##
## A step may be off by a part of the tolerance, so that the largest error of all frames stays near it: 1/400 where a
## general method has to follow every oscillation, all of it for `waveform', whose estimate is that of a worse
## polynomial than it takes, 1/4 else (measured on the scene `paper', tests below).
##
## Every interval between two breaks of the load is integrated for itself, so that no step runs across a break; loads
## are taken from inside it, since they jump at its ends.
## @var{count}: method, steps, calls of the rate, seconds, and still (see @code{stays}).
## @end deftypefn

function [states, count] = integrate (system, times, solver)
  tolerance = solver.tolerance;
  table = integrator_table ();
  method = table(strcmp (strrep (solver.name, "auto", "waveform"), {table.name}));
  turned = system.turned && any (strcmp (method.name, {"ode45", "ode23"}));
  if (turned || strcmp (method.name, "exponential") || ! method.adaptive)
    solver.tolerance /= 4;
  elseif (! strcmp (method.name, "waveform"))
    solver.tolerance /= 400;
  endif
  start = tic ();
  [times, ends] = meet_breaks (times, system.breaks);
  states = repmat (system.initial_state, 1, numel (times));
  y = system.initial_state;
  steps = 0;
  watch_rate (times(end));
  for k = 1:numel (ends) - 1
    interval = ends([k, k+1]);
    inside = times >= interval(1) & times <= interval(2);
    stops = unique ([interval(1), times(inside), interval(2)]);
    [reached, taken] = method.run (with_loads (system, interval), stops, y, solver);
    states(:,inside) = reached(:,ismember (stops, times(inside)));
    y = reached(:,end);
    steps += taken;
  endfor
  count = struct ("method", method.name, "steps", steps, "calls", watch_rate (), "seconds", toc (start));
  n = rows (system.mass);
  count.still = stays (states(1:n,:), system.state_scale(1:n), tolerance);
endfunction

## the system's rates, counted, with loads from inside an interval
function system = with_loads (system, interval)
  inside = inside_of (interval);
  rate = system.rate;
  system.rate = @(t, y) watch_rate (t, rate (t, y, inside));
  for form = intersect ({"momenta", "accelerations"}, fieldnames (system).')
    form_rate = system.(form{1}).rate;
    system.(form{1}).rate = @(t, z) watch_rate (t, form_rate (t, z, inside));
  endfor
endfunction

%!function system = pushed_mass ()   # x'' = 1 until t = 1, then 0
%!  system = struct ("initial_state", [0; 0], "breaks", 1, "state_scale", [1; 1], "turned", false, ...
%!                   "longest_step", Inf, "mass", 1, "stiffness", 0, "velocity_matrix", 1);
%!  system.rate = @(t, y, interval) [y(2); interval(2) < 1];
%!endfunction

%!test # a jump of the load is met exactly
%! [states, count] = integrate (pushed_mass (), [0 0.7 1.3 2], struct ("name", "ode45", "tolerance", 1e-6));
%! assert (states(1,:), [0, 0.7^2/2, 0.5 + 0.3, 1.5], 1e-12);
%! assert (count.calls > 20); assert (count.method, "ode45");

%!test # the largest error of all frames is near the tolerance or below it
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 1]), "duration", 0.6));
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! at = @(name, tolerance) integrate (system, 0:0.1:0.6, struct ("name", name, "tolerance", tolerance))(1:2,:);
%! reference = at ("exponential", 1e-10);
%! for tolerance = [1e-5 1e-6]
%!   for name = {"ode45", "exponential", "waveform"}
%!     assert (at (name{1}, tolerance), reference, tolerance);
%!   endfor
%! endfor

%!test # the relaxation has converged, too, where the longest waves of a ring couple strongly
%! rung = struct ("sines", [3 6], "bending", 6, "longitudinal", 3, "axial", "dynamic", "stiffening", "none");
%! scene = check_scene (setfield (setfield (ring (), "model", "modes", [3 6]), "duration", 0.3));
%! system = rod_system (scene, build_model (scene, rung));
%! at = @(name, tolerance) integrate (system, 0:0.1:0.3, struct ("name", name, "tolerance", tolerance))(1:10,:);
%! assert (at ("waveform", 1e-7), at ("exponential", 1e-8), 1e-7);
