## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} summarise (@var{name}, @var{scene}, @var{model}, @var{choice}, @var{count}, @
##   @var{history})
## What a run was and how it went: the struct that summary.json holds.
## @end deftypefn

function summary = summarise (name, scene, model, choice, count, history)
  summary.scene = name;
  summary.title = scene.title;
  summary.model = rung_name (model.rung);
  summary.modes = mode_numbers (model.rung);
  summary.axial = model.rung.axial;
  summary.stiffening = model.rung.stiffening;
  summary.model_reason = choice.reason;
  summary.energy = scene.model.energy;
  summary.moment_work = scene.model.moment_work;
  summary.rotary_inertia = logical (scene.model.rotary_inertia);
  summary.loads = scene.probed;
  summary.method = count.method;
  summary.tolerance_m = scene.solver.tolerance;
  summary.estimated_error_m = [];
  summary.estimated_error_pixels = summary.dropped_m = [];
  summary.tried = [];
  error_warnings = {};
  summary.seconds = struct ("choice", 0, "integration", count.seconds);
  if (! isempty (choice.trial))
    estimate = estimate_error (scene, model, choice, history);
    summary.estimated_error_m = estimate.metres;
    summary.dropped_m = estimate.dropped;
    half_pixel = tolerance_in_metres (setfield (scene, "solver", "tolerance", "pixel"));
    summary.estimated_error_pixels = summary.estimated_error_m/(2*half_pixel);
    summary.tried = rmfield (choice.tried, "rung");
    summary.seconds.choice = sum ([choice.tried.seconds, estimate.seconds]);
    if (isempty (choice.warnings) || estimate.dropped > scene.solver.tolerance)  # else the chooser has said it
      error_warnings = error_warning (scene, estimate);
    endif
  endif
  summary.steps = count.steps;
  summary.rate_calls = count.calls;
  summary.frames = numel (history.t);
  summary.largest_energy_error = max (energy_error (history));
  summary.warnings = [choice.warnings, energy_warning(summary.largest_energy_error, 1e-3), ...
                      error_warnings, validity_warnings(scene, model, history)];
endfunction

function modes = mode_numbers (rung)
  modes = [rung.longitudinal, rung.bending];
endfunction

%!test
%! result = driver ("paper", "modes", [0 0], "output", "", "tolerance", 1e-9);
%! assert (result.summary.largest_energy_error < 1e-8);
%! assert (result.summary.warnings, {});
%! [scene, model, history] = deal (result.scene, result.model, result.history);
%! history.balance(7) += 1;
%! count = struct ("method", "", "steps", 0, "calls", 0, "seconds", 0);
%! choice = struct ("trial", [], "reason", "", "warnings", {{}});
%! summary = summarise ("paper", scene, model, choice, count, history);
%! assert (numel (summary.warnings), 1);
%! assert (! isempty (strfind (summary.warnings{1}, "take a smaller tolerance")));
