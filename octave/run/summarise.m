## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} summarise (@var{kind}, @var{name}, @var{scene}, @var{run}, @var{choice})
## What the @var{run} of a scene of a @var{kind} (see @code{kind_of}) was, how its model was chosen (see @code{choose})
## and how it went: the struct that summary.json holds.
## @end deftypefn

function summary = summarise (kind, name, scene, run, choice)
  [history, count] = deal (run.history, run.count);
  summary.scene = name;
  summary.title = scene.title;
  summary.kind = kind.name;
  for [value, field] = kind.describe (scene, run)
    summary.(field) = value;
  endfor
  summary.model_reason = choice.reason;
  summary.loads = scene.probed;
  summary.method = count.method;
  summary.tolerance_m = scene.solver.tolerance;
  summary.estimated_error_m = summary.estimated_error_pixels = summary.dropped_m = [];
  summary.tried = [];
  summary.seconds = struct ("choice", 0, "integration", count.seconds);
  error_warnings = {};
  if (! isempty (choice.trial))
    estimate = estimate_error (kind, scene, run, choice.reference);
    summary.estimated_error_m = estimate.metres;
    summary.estimated_error_pixels = estimate.metres/kind.pixel (scene);
    summary.dropped_m = estimate.dropped;
    summary.tried = rmfield (choice.tried, "rung");
    summary.seconds.choice = sum ([choice.tried.seconds, estimate.seconds]);
    if (isempty (choice.warnings) || any (estimate.dropped > scene.solver.tolerance))  # else the chooser has said it
      error_warnings = error_warning (scene.solver.tolerance, estimate, kind.instead (scene));
    endif
  endif
  summary.steps = count.steps;
  summary.rate_calls = count.calls;
  summary.frames = numel (history.t);
  summary.largest_energy_error = max (energy_error (history));
  summary.warnings = [choice.warnings, error_warnings, run.warnings, ...
                      energy_warning(summary.largest_energy_error, 1e-3), kind.warnings(scene, run)];
endfunction

%!test
%! result = driver ("paper", "modes", [0 0], "output", "", "tolerance", 1e-9);
%! assert (result.summary.largest_energy_error < 1e-8);
%! assert (result.summary.warnings, {});
%! run = struct ("model", result.model, "history", result.history, "warnings", {{}});
%! run.history.balance(7) += 1;
%! run.count = struct ("method", "", "steps", 0, "calls", 0, "seconds", 0);
%! choice = struct ("trial", [], "reason", "", "warnings", {{}});
%! summary = summarise (rod_kind (), "paper", result.scene, run, choice);
%! assert (numel (summary.warnings), 1);
%! assert (! isempty (strfind (summary.warnings{1}, "take a smaller tolerance")));
