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
  summary.warnings = [frame_warnings(scene), choice.warnings, error_warnings, run.warnings, ...
                      energy_warning(summary.largest_energy_error), kind.warnings(scene, run)];
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
%!test # what was run, how it was chosen, and what it took
%! kind = struct ("name", "a kind", "describe", @(scene, run) struct ("model", "three terms"), ...
%!                "pixel", @(scene) 2e-3, "instead", @(scene) "", "warnings", @(scene, run) {"of the kind"}, ...
%!                "dropped", @(scene, run, reference) struct ("x", 0, "y", 0, "bound", 0, "metres", 5e-4));
%! scene = struct ("title", "A scene", "probed", "loads", "solver", struct ("tolerance", 1e-3));
%! [scene.duration, scene.frames_per_second] = deal (1, 1);
%! history = struct ("t", 1:2, "T", [0 2], "U", [0 0], "Z", [5 4], "W", [0 0], "D", [0 0], "balance", [5 5], ...
%!                   "energy_floor", 1e-12);
%! run = struct ("history", history, "warnings", {{"of the run"}}, "x", [0 0], "y", [0 0], ...
%!               "count", struct ("method", "rk4", "steps", 3, "calls", 12, "seconds", 7));
%! choice = struct ("trial", 1, "reference", struct ("x", [0 4e-3], "y", [0 0]), "reason", "the smallest", ...
%!                  "tried", struct ("rung", {1, 2}, "name", {"one", "two"}, "seconds", {10, 20}), ...
%!                  "warnings", {{"of the choice"}});
%! summary = summarise (kind, "its name", scene, run, choice);
%! expected = struct ("scene", "its name", "title", "A scene", "kind", "a kind", "model", "three terms", ...
%!                    "model_reason", "the smallest", "loads", "loads", "method", "rk4", "tolerance_m", 1e-3, ...
%!                    "dropped_m", 5e-4, "estimated_error_pixels", 2, "estimated_error_m", 4e-3, ...
%!                    "tried", struct ("name", {"one", "two"}, "seconds", {10, 20}), ...
%!                    "steps", 3, "rate_calls", 12, "frames", 2, "largest_energy_error", 0);
%! for [value, name] = expected
%!   assert (isequal (summary.(name), value), name);
%! endfor
%! assert (summary.seconds.integration, 7); assert (summary.seconds.choice, 30, 1);
%! assert (summary.warnings, {"of the choice", "of the run", "of the kind"});  # the choice has told the error
%! said = summarise (kind, "", scene, run, setfield (choice, "warnings", {})).warnings;
%! assert (numel (said), 3); assert (! isempty (strfind (said{1}, "0.004 m")));
%! said = summarise (kind, "", setfield (scene, "duration", 1.5), run, choice).warnings{1};
%! assert (strncmp (said, "the last frame is at 1 s, before the duration of 1.5 s", 54));
%! given = summarise (kind, "", scene, run, setfield (choice, "trial", []));
%! assert ({given.tried, given.estimated_error_m, given.dropped_m}, {[], [], []});
%! assert (given.seconds, struct ("choice", 0, "integration", 7));
