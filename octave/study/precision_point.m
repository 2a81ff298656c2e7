## -*- texinfo -*-
## @deftypefn {} {@var{row} =} precision_point (@var{scene}, @var{model}, @var{system}, @var{method}, @
##   @var{parameter}, @var{reference}, @var{budget})
## A row of the table of @code{work_precision}: a @var{method} (see @code{integrator_table}) with the @var{parameter}
## (tolerance in m, or step in s) against the @var{reference} (see @code{measure}).  What would take more than the
## @var{budget} (s) is run on a part of the duration, and given up after ten times as long.
## @end deftypefn

function row = precision_point (scene, model, system, method, parameter, reference, budget)
  solver = struct ("name", method.name, "tolerance", parameter, "step", [], "rho_infinity", scene.solver.rho_infinity);
  if (! method.adaptive)
    solver.step = parameter;
  endif
  row = struct ("method", method.name, "parameter", parameter, "tip_error", NaN, "phi_error", NaN, "seconds", 0, ...
                "calls", 0, "extrapolated", false, "failure", "");
  times = frame_times (scene);
  first = find (times > times(end)*0.02, 1);
  start = tic ();
  try
    [~, trial] = integrate (system, times(1:first), solver);
    part = numel (times);
    if (trial.seconds*times(end)/times(first) > budget)
      part = find (times <= times(end)*budget/(trial.seconds*times(end)/times(first)), 1, "last");
      part = max (part, first);
    endif
    limited = given_up (system, 10*budget);
    [states, count] = integrate (limited, times(1:part), solver);
    for repeat = 1:2*(count.seconds(1) < 1)
      [~, again] = integrate (system, times(1:part), solver);
      count.seconds(end+1) = again.seconds;
    endfor
    history = measure (system, model, times(1:part), states);
    [row.tip_error, row.phi_error] = precision_errors (history, reference);
    row.seconds = median (count.seconds)*times(end)/times(part);
    row.calls = round (count.calls*times(end)/times(part));
    row.extrapolated = part < numel (times);
    if (! row.extrapolated)  # the balance of a part is not small against its energy
      watch_balance (history, system, count);
    endif
  catch err
    if (! strcmp (err.identifier, "toolchain:integration"))
      rethrow (err);
    endif
    row.failure = strtrim (err.message);
    row.seconds = max (row.seconds, toc (start));
  end_try_catch
endfunction

## the system with rates that end in an error once they have taken so many seconds
function system = given_up (system, seconds)
  if (isinf (seconds))
    return;
  endif
  clock = tic ();
  rate = system.rate;
  system.rate = @(varargin) give_up (rate (varargin{:}), clock, seconds);
  for form = intersect ({"momenta", "accelerations"}, fieldnames (system).')
    form_rate = system.(form{1}).rate;
    system.(form{1}).rate = @(varargin) give_up (form_rate (varargin{:}), clock, seconds);
  endfor
endfunction

%!test # a step of rk4 beyond its stability fails, a smaller one is near; a short budget takes a part
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 1]), "duration", 0.2));
%! model = build_model (scene, rung_of_scene (scene));
%! system = rod_system (scene, model);
%! times = frame_times (scene);
%! solver = struct ("name", "waveform", "tolerance", 1e-9);
%! reference = measure (system, model, times, integrate (system, times, solver));
%! rk4 = integrator_table ()(strcmp ({integrator_table().name}, "rk4"));
%! row = precision_point (scene, model, system, rk4, 1e-2, reference, 20);
%! assert (strncmp (row.failure, "rk4 stopped", 11));
%! row = precision_point (scene, model, system, rk4, 1e-3, reference, 20);
%! assert (row.tip_error < 1e-3 && row.phi_error < 1e-3 && ! row.extrapolated); assert (row.failure, "");
