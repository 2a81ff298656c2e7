## -*- texinfo -*-
## @deftypefn {} {@var{spectrum} =} tip_spectrum (@var{scene}, @var{run})
## The spectra of the tip of one rod (see @code{spectrum_of_tip}) in a @var{run}, from the states between its frames
## (see @code{run_model}), at some three times the highest predicted frequency where they have it.  Empty without such
## states, or for a rigid rod.
## @end deftypefn

function spectrum = tip_spectrum (scene, run)
  spectrum = [];
  model = run.model;
  system = rod_system (scene, model);
  [modes, squares] = free_modes (system.stiffness, system.mass);
  frequencies = sqrt (max (0, squares)).'/(2*pi);
  fastest = max ([frequencies, 0]);
  if (fastest <= 1e-6 || ! isfield (run, "between"))
    return;
  endif
  t = run.between.t;
  picked = 1:max (1, floor (numel (t)/(2*ceil (1.5*fastest*scene.duration + 32)))):numel (t);
  motion = system.motion (t(picked), run.between.states(:,picked));
  spectrum = spectrum_of_tip (model, motion, diff (t(picked))(1), modes, frequencies, system.mass);
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
%! assert (tip_spectrum (scene, rmfield (run, "between")), []);
%!test # what lies beyond the rate is not folded back: no peak away from the predicted ones
%! scene = struct ("duration", 2, "gravity", 0, "initial", struct ("V2", [1 1 1 1]*1e-6));
%! scene.rod = struct ("length", 1, "width", 0.02, "half_height", 0.015);
%! scene.model.modes = [0 4];
%! scene.solver.tolerance = 1e-8; scene.frames_per_second = 32;
%! scene = check_scene (scene);
%! run = run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)), scene.solver, [], true);
%! spectrum = tip_spectrum (scene, run);
%! assert (regexp (spectrum.note, "^sampled at 2.048 kHz; \\d predicted ones lie beyond 1.024 kHz$"), 1);
%! assert (spectrum.predicted < 1024);
%! away = min (abs (spectrum.frequency.' - spectrum.predicted), [], 2) > 20;
%! assert (spectrum.values(2,away) < 0.01*max (spectrum.values(2,:)));
%!test # a rigid rod has none
%! [scene, model] = sample_rod ([0 0]);
%! assert (tip_spectrum (scene, struct ("model", model)), []);
