## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{count}] =} integrate (@var{system}, @var{times}, @var{solver})
## The states (a column a time) of a system of any kind at the @var{times} (1-by-m, s, from the start of the motion),
## by the method @var{solver}.name of @code{integrator_table} with @var{solver}.tolerance (m), or with steps of
## @var{solver}.step (s) where the method's steps are equal; "auto" is system.auto.  What takes longer than
## @var{solver}.seconds, where there is such a field, is given up: an error, and so is what becomes steeper than
## @var{solver}.steepest (see @code{refuse_steep}).
##
## A system has initial_state (its coordinates first), duration (s), breaks (times in s at which its loads jump),
## state_scale (what each state may be off by where a point is off by 1 m), mass and stiffness (of its coordinates,
## linear about the start: for what is said of its frequencies), the forms of equations (a cellstr), refusal (what to
## say of other methods of its kind, where there are some), auto (the method of a solver "auto") and for each form its
## functions: for "rate" the function rate (t, y), a column a state.
##
## Every interval between two breaks is integrated for itself, so that no step runs across a break; loads are taken
## from inside it, since they jump at its ends. @var{count}: method, steps, calls (of the system's functions, a column
## each), seconds, and still (see @code{stays}).
## @end deftypefn

function [states, count] = integrate (system, times, solver)
  method = method_of (system, solver.name);
  tolerance = solver.tolerance;
  solver.tolerance /= method.share;
  solver.name = method.name;
  limit = Inf;
  if (isfield (solver, "seconds"))
    limit = solver.seconds;
  endif
  for id = {"Octave:singular-matrix", "Octave:nearly-singular-matrix"}  # of what turns unstable; it has its own error
    warning ("off", id{1}, "local");
  endfor
  clock = tic ();
  calls = shown = 0;
  watched = on_terminal ();
  told = [];
  if (isfinite (limit))
    told = [Inf, 0];  # then it is known how long, at most
  endif
  system.calls = @calls_so_far;
  [times, ends] = meet_breaks (times, system.breaks);
  y = system.initial_state;
  states = repmat (y, 1, numel (times));
  steps = 0;
  for k = 1:numel (ends) - 1
    interval = ends([k, k+1]);
    inside = times >= interval(1) & times <= interval(2);
    stops = unique ([interval(1), times(inside), interval(2)]);
    [reached, taken] = method.run (between_breaks (system, interval, @counted), stops, y, solver);
    states(:,inside) = reached(:,ismember (stops, times(inside)));
    y = reached(:,end);
    steps += taken;
  endfor
  show_progress ("");
  count = struct ("method", method.name, "steps", steps, "calls", calls, "seconds", toc (clock));
  n = rows (system.mass);
  count.still = stays (states(1:n,:), system.state_scale(1:n), tolerance);

  ## values that the system has at the times t pass, and are counted; on a terminal it shows how far it has come, else
  ## how long it will take
  function value = counted (t, value)
    calls += columns (value);
    if (isfinite (limit) && toc (clock) > limit)
      error ("toolchain:integration:time", "given up after %.0f s\n", limit);
    endif
    if (calls >= shown + 50)
      shown = calls;
      if (watched)
        show_integration (t(end), times(end), calls, clock);
      else
        told = announce_seconds (told, t(end), times(end), toc (clock));
      endif
    endif
  endfunction

  function sum = calls_so_far ()
    sum = calls;
  endfunction
endfunction

%!function system = pushed_mass ()   # x'' = 1 until t = 1, then 0
%!  system = struct ("initial_state", [0; 0], "breaks", 1, "state_scale", [1; 1], ...
%!                   "longest_step", Inf, "mass", 1, "stiffness", 0, "velocity_matrix", 1, "forms", {{"rate"}});
%!  system.rate = @(t, y) [y(2); t < 1];
%!endfunction
%!test # a jump of the load is met exactly
%! [states, count] = integrate (pushed_mass (), [0 0.7 1.3 2], struct ("name", "ode45", "tolerance", 1e-6));
%! assert (states(1,:), [0, 0.7^2/2, 0.5 + 0.3, 1.5], 1e-12);
%! assert (count.calls > 20); assert (count.method, "ode45");
%!error <given up after 0 s>
%! integrate (pushed_mass (), [0 1], struct ("name", "ode45", "tolerance", 1e-6, "seconds", 0));
%!error id=toolchain:integration:time
%! integrate (pushed_mass (), [0 1], struct ("name", "ode45", "tolerance", 1e-6, "seconds", 0));
%!test # the largest error of all frames is near the tolerance or below it
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 1]), "duration", 0.4));
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! at = @(name, tolerance) integrate (system, 0:0.1:0.4, struct ("name", name, "tolerance", tolerance))(1:2,:);
%! reference = at ("exponential", 1e-10);
%! for tolerance = [1e-4 1e-5]
%!   for name = {"ode45", "exponential", "waveform"}
%!     assert (at (name{1}, tolerance), reference, tolerance);
%!   endfor
%! endfor
%!test # the relaxation has converged, too, where the longest waves of a ring couple strongly
%! rung = struct ("sines", [3 6], "bending", 6, "longitudinal", 3, "axial", "dynamic", "stiffening", "none");
%! scene = check_scene (setfield (setfield (ring (), "model", "modes", [3 6]), "duration", 0.1));
%! system = rod_system (scene, build_curved_model (scene, rung));
%! at = @(name, tolerance) integrate (system, 0:0.05:0.1, struct ("name", name, "tolerance", tolerance))(1:10,:);
%! assert (at ("waveform", 1e-7), at ("exponential", 1e-8), 1e-7);
%!test # a load's break is met by a mechanism: M = 1 N m until t = 0.1 s does the work M phi
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 2), "model", struct ("modes", [0 0]))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "moment", "bodies", 1, "stations", 0, "value", @(t) double (t < 0.1))};
%! [scene.duration, scene.breaks] = deal (1, 0.1);
%! scene = check_mechanism (scene);
%! system = assembled_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%! [states, count] = integrate (system, [0 0.1 0.5], struct ("name", "auto", "tolerance", 1e-9));
%! states = named_rows (system, states);
%! assert (states.W(2:3), states.q(1,2)*[1 1], 1e-9);
%! assert (count.method, "radau");
