## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} summarise_surface (@var{name}, @var{run}, @var{choice})
## What a @var{run} of a rod on a surface was, how it was chosen (see @code{choose}) and how it went: the
## struct that summary.json holds.
## @end deftypefn

function summary = summarise_surface (name, run, choice)
  [scene, history, count] = deal (run.scene, run.history, run.count);
  summary.scene = name;
  summary.title = scene.title;
  summary.model = sprintf ("%d + %d base functions on the surface %s", scene.model.modes + scene.model.sines, ...
                           scene.surface.name);
  summary.model_reason = choice.reason;
  summary.surface = scene.surface;
  summary.modes = scene.model.modes;
  summary.sines = scene.model.sines;
  summary.ends = scene.ends;
  summary.loads = scene.probed;
  summary.method = count.method;
  summary.tolerance_m = scene.solver.tolerance;
  summary.estimated_error_m = [];
  summary.tried = [];
  error_warnings = {};
  if (! isempty (choice.trial))
    summary.estimated_error_m = distance (history, choice.reference);
    summary.tried = rmfield (choice.tried, "rung");
    if (isempty (choice.warnings))  # else the chooser has said it
      metres = summary.estimated_error_m;
      error_warnings = error_warning (scene, struct ("metres", metres, "of_choice", metres, "dropped", []));
    endif
  endif
  summary.estimated_error_pixels = summary.estimated_error_m*min (scene.frame_size)/scene.rod.length;
  summary.steps = count.steps;
  summary.rate_calls = count.calls;
  summary.frames = numel (history.t);
  summary.seconds = struct ("choice", 0, "integration", count.seconds);
  if (! isempty (choice.tried))
    summary.seconds.choice = sum ([choice.tried.seconds]);
  endif
  summary.largest_energy_error = max (energy_error (history));
  summary.angular_momentum_change = max (abs (history.angular_momentum - history.angular_momentum(:,1)), [], 2).';
  summary.largest_strain = history.largest_strain;
  summary.reaction = [min(history.reaction(:)), max(history.reaction(:))];
  last = cumsum (scene.model.modes + scene.model.sines);
  summary.largest_end_coefficient = max (abs (history.q(last,:))(:))/scene.rod.length;
  summary.warnings = [choice.warnings, error_warnings, pull_warning(history, scene), ...
                      strain_warning(history.largest_strain), energy_warning(summary.largest_energy_error, 1e-7)];
endfunction

function warnings = pull_warning (history, scene)
  warnings = {};
  push = scene.surface.side*history.reaction;
  [least, k] = min (min (push, [], 1));
  if (least < -1e-6*max (abs (push(:))))
    first = find (min (push, [], 1) < -1e-6*max (abs (push(:))), 1);
    warnings = {sprintf(["the surface would have to pull the rod from t = %.4g s on, by up to %.3g N/m at" ...
                         " t = %.4g s: a rod on one side would lift off there; surface.side = 0 has a rod" ...
                         " that cannot"], history.t(first), -least, history.t(k))};
  endif
endfunction

function warnings = strain_warning (strain)
  warnings = {};
  if (strain > 0.05)
    warnings = {sprintf("the axial strain reaches %.2g, linear elasticity holds for small ones: take a larger EA", ...
                        strain)};
  endif
endfunction

%!test # a rod flung over a hill would lift off
%! scene = struct ("surface", struct ("name", "sphere", "radius", 1, "side", -1), "duration", 0.02, ...
%!                 "rod", struct ("length", 0.1, "EA", 3e3, "EI", 0.1, "EI_normal", 0, "rhoA", 1.5), ...
%!                 "model", struct ("modes", [4 4]));
%! scene.initial.velocity = @(xi, alpha) [0.2 + 0*xi; 0*xi];
%! result = driver (scene, "output", "");
%! assert (! isempty (strfind (result.summary.warnings{1}, "would have to pull the rod from t = 0 s on")));
%! assert (driver (setfield (scene, "surface", "side", 1), "output", "").summary.warnings, {});
