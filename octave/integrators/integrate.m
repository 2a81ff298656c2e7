## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{count}] =} integrate (@var{system}, @var{times}, @var{solver})
## The states (n-by-m) of a system (see @code{hinged_rod}) at the @var{times} (1-by-m, s, from the start of the motion),
## by the method @var{solver}.name with @var{solver}.tolerance (m).
##
## A step may be off by a quarter of the tolerance: on the scene `paper' with [0 1] modes the largest error of all frames
## is then 0.4 to 0.5 tolerances, for tolerances of 1e-5 to 1e-8 m (test below).
##
## Every interval between two breaks of the load is integrated for itself, so that no step runs across a break; loads
## are taken from inside it, since they jump at its ends.
## @var{count}: method, steps, calls of the rate and seconds.
## @end deftypefn

function [states, count] = integrate (system, times, solver)
  methods = struct ("auto", @integrate_ode45, "ode45", @integrate_ode45);
  method = methods.(solver.name);
  start = tic ();
  breaks = system.breaks(system.breaks > times(1) & system.breaks < times(end));
  ends = [times(1), breaks, times(end)];
  states = zeros (numel (system.initial_state), numel (times));
  y = system.initial_state;
  watch_rate (times(end));
  for k = 1:numel (ends) - 1
    interval = ends([k, k+1]);
    inside = times >= interval(1) & times <= interval(2);
    stops = unique ([interval(1), times(inside), interval(2)]);
    inside_load = interval + [1, -1].*eps (interval);
    rate = @(t, y) watch_rate (t, system.rate (t, y, inside_load));
    [reached, steps_per_call] = method (rate, stops, y, solver.tolerance/4, system.state_scale);
    states(:,inside) = reached(:,ismember (stops, times(inside)));
    y = reached(:,end);
  endfor
  calls = watch_rate ();
  count = struct ("method", func2str (method)(11:end), "steps", round (calls*steps_per_call), "calls", calls, ...
                  "seconds", toc (start));
endfunction

%!function system = pushed_mass ()   # x'' = 1 until t = 1, then 0
%!  system = struct ("initial_state", [0; 0], "breaks", 1, "state_scale", [1; 1]);
%!  system.rate = @(t, y, interval) [y(2); interval(2) < 1];
%!endfunction

%!test # a jump of the load is met exactly
%! [states, count] = integrate (pushed_mass (), [0 0.7 1.3 2], struct ("name", "ode45", "tolerance", 1e-6));
%! assert (states(1,:), [0, 0.7^2/2, 0.5 + 0.3, 1.5], 1e-12);
%! assert (count.calls > 20); assert (count.method, "ode45");

%!test # the largest error of all frames is below the tolerance
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 1]), "duration", 0.6));
%! system = hinged_rod (scene, build_model (scene));
%! reference = integrate (system, 0:0.1:0.6, struct ("name", "ode45", "tolerance", 1e-9));
%! coarse = integrate (system, 0:0.1:0.6, struct ("name", "ode45", "tolerance", 1e-6));
%! assert (max (abs (coarse - reference)(1:2,:)(:)) < 1e-6);
