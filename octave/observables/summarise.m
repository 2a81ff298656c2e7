## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} summarise (@var{name}, @var{scene}, @var{model}, @var{count}, @var{history})
## What a run was and how it went: the struct that summary.json holds.
## @end deftypefn

function summary = summarise (name, scene, model, count, history)
  summary.scene = name;
  summary.title = scene.title;
  summary.modes = model.modes;
  summary.model_reason = model.reason;
  summary.energy = scene.model.energy;
  summary.moment_work = scene.model.moment_work;
  summary.rotary_inertia = logical (scene.model.rotary_inertia);
  summary.method = count.method;
  summary.tolerance_m = scene.solver.tolerance;
  summary.estimated_error_m = [];
  summary.steps = count.steps;
  summary.rate_calls = count.calls;
  summary.frames = numel (history.t);
  summary.seconds = struct ("integration", count.seconds);
  summary.largest_energy_error = largest_energy_error (history);
  summary.warnings = energy_warning (summary.largest_energy_error);
endfunction

## of the balance T + U + Z + D - W, as a part of the largest energy
function relative = largest_energy_error (history)
  largest = max (abs ([history.T, history.U, history.Z - history.Z(1), history.W]));
  relative = max (abs (history.balance - history.balance(1)))/max (largest, realmin);
endfunction

function warnings = energy_warning (relative)
  warnings = {};
  if (relative > 1e-3)
    warnings = {sprintf("the energy balance is off by %.1g of the largest energy: take a smaller tolerance", relative)};
  endif
endfunction

%!test
%! result = driver ("paper", "modes", [0 0], "output", "", "tolerance", 1e-9);
%! assert (result.summary.largest_energy_error < 1e-8);
%! assert (result.summary.warnings, {});
%! [scene, model, history] = deal (result.scene, result.model, result.history);
%! history.balance(7) += 1;
%! summary = summarise ("paper", scene, model, struct ("method", "", "steps", 0, "calls", 0, "seconds", 0), history);
%! assert (numel (summary.warnings), 1);
%! assert (! isempty (strfind (summary.warnings{1}, "take a smaller tolerance")));
