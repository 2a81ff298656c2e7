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
  summary.seconds = struct ("choice", 0, "integration", count.seconds);
  if (! isempty (choice.trial))
    summary.dropped_m = dropped_of_bodies (scene, mechanism, history);
    summary.estimated_error_m = distance (mechanism_points (mechanism, history), choice.reference) + summary.dropped_m;
    half_pixel = mechanism_tolerance (setfield (scene, "solver", "tolerance", "pixel"));
    summary.estimated_error_pixels = summary.estimated_error_m/(2*half_pixel);
    summary.tried = rmfield (choice.tried, "rung");
    summary.seconds.choice = sum ([choice.tried.seconds]);
  endif
  summary.steps = count.steps;
  summary.rate_calls = count.calls;
  summary.frames = numel (history.t);
  summary.largest_energy_error = max (energy_error (history));
  summary.largest_constraint_residual = max (history.residual);
  summary.largest_constraint_velocity = max (history.velocity_residual);
  summary.warnings = [choice.warnings, warnings, energy_warning(summary.largest_energy_error, 1e-3), dropped_warning(summary), ...
                      large_deflections(scene, mechanism, history)];
endfunction

function warnings = dropped_warning (summary)
  warnings = {};
  if (! isempty (summary.dropped_m) && summary.dropped_m > summary.tolerance_m)
    warnings = {sprintf(["what the models drop beyond foreshortening moves the rods by some %.2g m, the tolerance is" ...
                         " %.2g m: take a rod that bends so much as several shorter ones welded together"], ...
                        summary.dropped_m, summary.tolerance_m)};
  endif
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
