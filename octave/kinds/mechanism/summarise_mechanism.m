## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} summarise_mechanism (@var{name}, @var{scene}, @var{mechanism}, @var{choice}, @
##   @var{count}, @var{history}, @var{warnings})
## What a mechanism's run was and how it went: the struct that summary.json holds.
## @end deftypefn

function summary = summarise_mechanism (name, scene, mechanism, choice, count, history, warnings)
  summary.scene = name;
  summary.title = scene.title;
  summary.bodies = {scene.bodies.name};
  summary.joints = {scene.joints(:).name};
  summary.model = sprintf ("%d bodies, %d coordinates, %d constraints", numel (scene.bodies), mechanism.n, ...
                           mechanism.constraints.count);
  summary.model_reason = choice.reason;
  modes = @(model) [model.rung.longitudinal, model.rung.bending];
  summary.modes = cellfun (modes, mechanism.models, "uniformoutput", false);
  summary.stiffening = cellfun (@(model) model.rung.stiffening, mechanism.models, "uniformoutput", false);
  summary.loads = scene.probed;
  summary.method = count.method;
  summary.tolerance_m = scene.solver.tolerance;
  summary.estimated_error_m = [];
  summary.estimated_error_pixels = summary.dropped_m = [];
  summary.tried = [];
  error_warnings = {};
  summary.seconds = struct ("choice", 0, "integration", count.seconds);
  if (! isempty (choice.trial))
    estimate.of_choice = distance (mechanism_points (mechanism, history), choice.reference);
    estimate.dropped = dropped_of_bodies (scene, mechanism, history);
    estimate.metres = sum ([estimate.of_choice, estimate.dropped]);
    summary.dropped_m = estimate.dropped;
    summary.estimated_error_m = estimate.metres;
    half_pixel = mechanism_tolerance (setfield (scene, "solver", "tolerance", "pixel"));
    summary.estimated_error_pixels = summary.estimated_error_m/(2*half_pixel);
    summary.tried = rmfield (choice.tried, "rung");
    summary.seconds.choice = sum ([choice.tried.seconds]);
    if (isempty (choice.warnings) || estimate.dropped > scene.solver.tolerance)  # else the chooser has said it
      error_warnings = error_warning (scene, estimate);
    endif
  endif
  summary.steps = count.steps;
  summary.rate_calls = count.calls;
  summary.frames = numel (history.t);
  summary.largest_energy_error = max (energy_error (history));
  summary.largest_constraint_residual = max (history.residual);
  summary.largest_constraint_velocity = max (history.velocity_residual);
  summary.warnings = [choice.warnings, error_warnings, warnings, ...
                      energy_warning(summary.largest_energy_error, 1e-3), ...
                      large_deflections(scene, mechanism, history)];
endfunction

## the rods' bending is linear: it holds for small slopes
function warnings = large_deflections (scene, mechanism, history)
  warnings = {};
  for k = 1:numel (history.bodies)
    base = mechanism.models{k}.base;
    [~, slopes] = functions_at (base, linspace (0, base.length, 21), 1);
    steepest = max (abs (slopes*history.bodies(k).V)(:));
    if (steepest > 0.3)
      warnings{end+1} = sprintf (["%s bends to a slope of %.2g: the model holds below some 0.3; take it as several" ...
                                  " rods welded together"], scene.bodies(k).name, steepest);
    endif
  endfor
endfunction

%!test # a rod that bends too far is named
%! [system, start, scene] = sample_mechanism ([0 1]);
%! start.q(index_of (system.mechanism, 2)(1)) = 0.1;
%! history = measure_mechanism (system, 0, first_states (system, 0, start));
%! choice = given_choice ([], "");
%! count = struct ("method", "radau", "seconds", 1, "steps", 2, "calls", 3);
%! summary = summarise_mechanism ("sample", scene, system.mechanism, choice, count, history, {});
%! assert (! isempty (regexp (summary.warnings{1}, "body 2 bends to a slope of 0.63")));
%!test # what the chooser has said, or that the run by another solver is off by more than the tolerance
%! scene = setfield (chain (1), "duration", 0.04);
%! scene.bodies{1}.model.modes = "auto";
%! scene.solver = struct ("name", "variational", "step", 0.02, "tolerance", 1e-7);
%! result = driver (scene, "output", "");
%! assert (result.summary.estimated_error_m > 1e-7);
%! said = @(text) any (! cellfun (@isempty, strfind (result.summary.warnings, text)));
%! assert (said ("the estimated error is"));
%! assert (isempty (strfind (result.summary.model_reason, "the largest")));
