## -*- texinfo -*-
## @deftypefn {} {@var{row} =} precision_point (@var{kind}, @var{scene}, @var{model}, @var{method}, @var{parameter}, @
##   @var{reference}, @var{budget})
## A row of the table of @code{work_precision}: a @var{method} (see @code{integrator_table}) with the @var{parameter}
## (tolerance in m, or step in s) against the run @var{reference}.  What would take more than the @var{budget} (s) is run
## on a part of the duration, and given up after ten times as long.
##
## @var{row} is a struct of method, parameter, error_m, drift (of constraints, m or rad; NaN without), seconds (a median of
## three where they are short), calls, extrapolated and failure.
## @end deftypefn

function row = precision_point (kind, scene, model, method, parameter, reference, budget)
  solver = setfield (setfield (scene.solver, "name", method.name), "tolerance", parameter);
  solver.seconds = 10*budget;
  solver.step = [];
  if (! method.adaptive)
    solver.step = parameter;
  endif
  row = struct ("method", method.name, "parameter", parameter, "error_m", NaN, "drift", NaN, "seconds", 0, ...
                "calls", 0, "extrapolated", false, "failure", "");
  times = frame_times (scene);
  first = find (times > times(end)*0.02, 1);
  start = tic ();
  try
    system = kind.system (scene, model);
    [~, trial] = integrate (system, times(1:first), solver);
    part = numel (times);
    expected = trial.seconds*times(end)/times(first);
    if (expected > budget)
      part = max (first, find (times <= times(end)*budget/expected, 1, "last"));
    endif
    [states, count] = integrate (system, times(1:part), solver);
    seconds = count.seconds;
    while (seconds(1) < 1 && numel (seconds) < 3)
      [~, again] = integrate (system, times(1:part), solver);
      seconds(end+1) = again.seconds;
    endwhile
    run = kind.observe (scene, model, system, times(1:part), states);
    row.error_m = distance (run, part_of (reference, part));
    if (isfield (run.history, "residual"))
      row.drift = max (run.history.residual);
    endif
    row.seconds = median (seconds)*times(end)/times(part);
    row.calls = round (count.calls*times(end)/times(part));
    row.extrapolated = part < numel (times);
    if (! row.extrapolated)  # the balance of a part is not small against its energy
      watch_balance (run.history, system, count);
    endif
  catch err
    if (! any (strcmp (err.identifier, {"toolchain:integration", "toolchain:scene"})))
      rethrow (err);
    endif
    row.failure = strtrim (err.message);
    row.seconds = max (row.seconds, toc (start));
  end_try_catch
endfunction

## the first frames
function points = part_of (run, frames)
  for axis = intersect ({"x", "y", "z"}, fieldnames (run).')
    points.(axis{1}) = run.(axis{1})(:,1:frames);
  endfor
endfunction

%!test # a step of rk4 beyond its stability fails, a smaller one is near; a short budget takes a part
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 1]), "duration", 0.2));
%! model = build_model (scene, rung_of_scene (scene));
%! reference = run_model (rod_kind (), scene, model, struct ("name", "waveform", "tolerance", 1e-9));
%! rk4 = integrator_table ()(strcmp ({integrator_table().name}, "rk4"));
%! point = @(step, budget) precision_point (rod_kind (), scene, model, rk4, step, reference, budget);
%! assert (strncmp (point (1e-2, 20).failure, "rk4 stopped", 11));
%! row = point (1e-3, 20);
%! assert (row.error_m < 1e-3 && ! row.extrapolated); assert (row.failure, ""); assert (row.drift, NaN);
%! row = point (1e-4, 0.1);
%! assert (row.extrapolated && row.error_m < 1e-6);
%! ## calls of the whole, also where it took a part; a scene's step is for what has equal steps
%! assert (row.calls, 4*0.2/1e-4, -0.01); assert (point (1e-3, 20).calls, 4*0.2/1e-3);
%! ode45 = integrator_table ()(strcmp ({integrator_table().name}, "ode45"));
%! stepped = setfield (scene, "solver", "step", 0.01);
%! row = precision_point (rod_kind (), stepped, model, ode45, 1e-5, reference, 20);
%! assert (row.error_m <= 1e-5); assert ({row.method, row.parameter, row.failure}, {"ode45", 1e-5, ""});
