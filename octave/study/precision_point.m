## -*- texinfo -*-
## @deftypefn {} {@var{row} =} precision_point (@var{kind}, @var{scene}, @var{model}, @var{method}, @var{parameter}, @
##   @var{reference}, @var{limit}, @var{expected})
## A row of the table of @code{work_precision}: a @var{method} (see
## @code{integrator_table}) with the @var{parameter} (tolerance in m, or step in s) against the run @var{reference}
## (see @code{reference_run}).  What would take more than the @var{limit} (s) is run on a part of the duration: seconds
## and calls go on as they did at its end, and an error above that of the reference itself grows as the time
## does.  @var{expected} is a guess of the seconds that the whole takes (NaN: none, then parts that grow tell).
##
## @var{row} is a struct of method, parameter, error_m, drift (of constraints, m or rad; NaN without), seconds (a
## median of three where they are short), calls, part (of the duration that was run, 1: the whole) and failure.
## @end deftypefn

function row = precision_point (kind, scene, model, method, parameter, reference, limit, expected = NaN)
  solver = setfield (setfield (scene.solver, "name", method.name), "tolerance", parameter);
  solver.step = [];
  if (! method.adaptive)
    solver.step = parameter;
  endif
  row = struct ("method", method.name, "parameter", parameter, "error_m", NaN, "drift", NaN, "seconds", NaN, ...
                "calls", 0, "part", 1, "failure", "");
  start = tic ();
  try
    system = started_system (kind, scene, model);
    [times, states, count, before] = as_far_as (system, scene, solver, reference.times, limit, expected);
    run = kind.observe (scene, model, system, times, states);
    last = frame_times (scene)(end);
    row.part = times(end)/last;
    row.error_m = distance (run, points_at (reference, times));
    if (row.error_m > reference.off/10)
      row.error_m /= row.part;  # errors grow with time
    endif
    if (isfield (run.history, "residual"))
      row.drift = max (run.history.residual);
    endif
    rest = (last - times(end))/(times(end) - before.t);
    row.seconds = count.seconds + rest*max (count.seconds - before.seconds, 0);
    row.calls = round (count.calls + rest*(count.calls - before.calls));
    if (row.part == 1)  # the balance of a part is not small against its energy
      watch_balance (run.history, system, count);
      row.seconds = timed_again (system, times, solver, count.seconds, limit);
    endif
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
    row.failure = strtrim (err.message);
    row.seconds = max ([row.seconds, toc(start)]);
  end_try_catch
endfunction

## parts that grow while the limit lasts, to the whole; and t, seconds and calls of the part before the last
function [times, states, count, before] = as_far_as (system, scene, solver, known, limit, expected)
  frames = frame_times (scene);
  none = struct ("t", 0, "seconds", 0, "calls", 0);
  [reached, before] = deal (none);
  end_time = known(2);
  if (isfinite (expected))
    end_time = frames(end)*limit/(2*expected);
  endif
  left = limit;
  do
    start = tic ();
    next = frames;
    if (end_time < frames(end))
      next = known(known <= max (end_time, known(2)));
    endif
    solver.seconds = max (2*left, limit);
    try
      [found, taken] = integrate (system, next, solver);
    catch err
      rethrow_others (err, "toolchain:integration:time");
      if (reached.t == 0 && next(end) <= known(2))
        rethrow (err);
      elseif (reached.t == 0)  # a guess too low
        [times, states, count, before] = as_far_as (system, scene, solver, known, limit, 32*expected);
      endif
      return;
    end_try_catch
    [times, states, count] = deal (next, found, taken);
    before = reached;
    reached = struct ("t", times(end), "seconds", count.seconds, "calls", count.calls);
    left -= toc (start);
    a_second = (reached.seconds - before.seconds)/(reached.t - before.t);
    end_time = reached.t + (left - reached.seconds)/max (a_second, realmin);
  until (times(end) == frames(end) || end_time < 2*reached.t)
  if (times(end) == frames(end))
    before = none;
  endif
endfunction

function seconds = timed_again (system, times, solver, seconds, limit)
  while (sum (seconds) < min (1, limit/2) && numel (seconds) < 3)
    [~, again] = integrate (system, times, solver);
    seconds(end+1) = again.seconds;
  endwhile
  seconds = median (seconds);
endfunction

function points = points_at (run, times)
  at = ismember (run.times, times);
  for axis = intersect ({"x", "y", "z"}, fieldnames (run).')
    points.(axis{1}) = run.(axis{1})(:,at);
  endfor
endfunction

%!test # a step of rk4 beyond its stability fails, a smaller one is near; little time takes a part
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 1]), "duration", 0.2));
%! model = build_model (scene, rung_of_scene (scene));
%! reference = reference_run (rod_kind (), scene, model, 60);
%! rk4 = integrator_table ()(strcmp ({integrator_table().name}, "rk4"));
%! point = @(step, limit) precision_point (rod_kind (), scene, model, rk4, step, reference, limit);
%! assert (strncmp (point (1e-2, 20).failure, "rk4 stopped", 11));
%! row = point (1e-3, 20);
%! assert (row.error_m < 1e-3 && row.part == 1); assert (row.failure, ""); assert (row.drift, NaN);
%! assert (row.calls, 4*200);
%! row = point (1e-5, 0.1);
%! assert (row.error_m < 1e-6 && row.part < 1); assert (row.calls, 4*0.2/1e-5, -0.1);
%! ode45 = integrator_table ()(strcmp ({integrator_table().name}, "ode45"));
%! stepped = setfield (scene, "solver", "step", 0.01);
%! row = precision_point (rod_kind (), stepped, model, ode45, 1e-5, reference, 20);
%! assert (row.error_m <= 1e-5); assert ({row.method, row.parameter, row.failure}, {"ode45", 1e-5, ""});
%!function y_dot = give_up (rate, t, varargin)   # after 0.05 s
%!  if (t > 0.05)
%!    error ("toolchain:integration", "given up late\n");
%!  endif
%!  y_dot = rate (t, varargin{:});
%!endfunction
%!test # a failure after a part that went well is the row's, and no shorter curve
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 1]), "duration", 0.2));
%! model = build_model (scene, rung_of_scene (scene));
%! kind = rod_kind ();
%! reference = reference_run (kind, scene, model, 60);
%! system = kind.system;
%! late = @(system) setfield (system, "rate", @(varargin) give_up (system.rate, varargin{:}));
%! kind.system = @(varargin) late (system (varargin{:}));
%! ode45 = integrator_table ()(strcmp ({integrator_table().name}, "ode45"));
%! row = precision_point (kind, scene, model, ode45, 1e-5, reference, 20);
%! assert (! isempty (strfind (row.failure, "given up late"))); assert (row.part, 1);
