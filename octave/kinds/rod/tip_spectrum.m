## -*- texinfo -*-
## @deftypefn {} {@var{spectrum} =} tip_spectrum (@var{scene}, @var{run})
## The spectra of a hinged rod's tip (see @code{spectrum_of_tip}) in a @var{run}; empty for a rigid rod.
##
## The frames are too far apart for it: the states between them are sampled at three times the highest predicted
## frequency, or as often as the @var{run} has them (see @code{run_model}); where it has none, the motion is integrated
## once more, for 4096 times at most.
## @end deftypefn

function spectrum = tip_spectrum (scene, run)
  spectrum = [];
  model = run.model;
  system = rod_system (scene, model);
  [modes, squares] = free_modes (system.stiffness, system.mass);
  frequencies = sqrt (max (0, squares)).'/(2*pi);
  fastest = max ([frequencies, 0]);
  if (fastest <= 1e-6)
    return;
  endif
  [times, states] = sampled (run, system, scene, 2*ceil (1.5*fastest*scene.duration + 32));
  if (isempty (times))
    return;
  endif
  spectrum = spectrum_of_tip (model, system.motion (times, states), diff (times)(1), modes, frequencies, system.mass);
endfunction

## so many times or more, if there are
function [times, states] = sampled (run, system, scene, samples)
  if (isfield (run, "between"))
    picked = 1:max (1, floor (numel (run.between.t)/samples)):numel (run.between.t);
    times = run.between.t(picked);
    states = run.between.states(:,picked);
    return;
  endif
  samples = min (4096, samples);
  times = (0:samples - 1)*scene.duration/samples;
  try
    states = integrate (system, times, struct ("name", "auto", "tolerance", scene.solver.tolerance));
  catch err
    rethrow_others (err, "toolchain:integration");
    times = states = [];
  end_try_catch
endfunction

%!test # a rod struck softly oscillates at its first frequency, with its amplitude
%! scene = struct ("duration", 0.5, "gravity", 0, "initial", struct ("V2", 1e-5), ...
%!                 "solver", struct ("tolerance", 1e-9));
%! scene.rod = struct ("length", 1, "width", 0.02, "half_height", 0.015);
%! scene.model = struct ("modes", [0 2], "energy", "uniaxial");
%! scene = check_scene (scene);
%! run = run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)), scene.solver, [], true);
%! spectrum = tip_spectrum (scene, run);
%! [largest, k] = max (spectrum.values(2,:));
%! E = 8.1e10*(3*1.2e11 + 2*8.1e10)/(1.2e11 + 8.1e10);
%! assert (spectrum.predicted(1), 3.926602^2*sqrt (E/7800*0.015^2/3)/(2*pi), 3);
%! assert (spectrum.frequency(k), spectrum.predicted(1), 2/0.5);
%! assert (isempty (strfind (spectrum.note, "beyond")));
%! rate = sscanf (spectrum.note, "sampled at %g kHz")*1000;
%! assert (rate/spectrum.predicted(end), 4, 1); assert (numel (spectrum.predicted), 2);
%! again = tip_spectrum (scene, rmfield (run, "between"));
%! [largest_again, k] = max (again.values(2,:));
%! assert (largest_again, largest, -0.05); assert (again.frequency(k), spectrum.predicted(1), 2/0.5);
%!test # what lies beyond the rate is not folded back: no peak away from the predicted ones
%! scene = struct ("duration", 2, "gravity", 0, "initial", struct ("V2", [1 1 1 1]*1e-6));
%! scene.rod = struct ("length", 1, "width", 0.02, "half_height", 0.015);
%! scene.model.modes = [0 4];
%! scene.solver.tolerance = 1e-8;
%! scene = check_scene (scene);
%! spectrum = tip_spectrum (scene, struct ("model", build_model (scene, rung_of_scene (scene))));
%! assert (regexp (spectrum.note, "^sampled at 2.048 kHz; \\d predicted ones lie beyond 1.024 kHz$"), 1);
%! assert (spectrum.predicted < 1024);
%! away = min (abs (spectrum.frequency.' - spectrum.predicted), [], 2) > 20;
%! assert (spectrum.values(2,away) < 0.01*max (spectrum.values(2,:)));
%!test # a rigid rod has none
%! [scene, model] = sample_rod ([0 0]);
%! assert (tip_spectrum (scene, struct ("model", model)), []);
%!test # nor has one whose motion cannot be integrated once more
%! [scene, model] = sample_rod ([0 2]);
%! scene.moment = @(t) NaN*t;
%! assert (tip_spectrum (scene, struct ("model", model)), []);
