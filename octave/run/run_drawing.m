## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} run_drawing (@var{kind}, @var{scene}, @var{run})
## What the pictures of a @var{run} show (see @code{draw_pictures}): the drawing of its @var{kind} and the spectrum.
## The panels of @file{history.svg} are from some 2000 times of the run, panel_time, where the frames' samples miss
## what is between them: where a curve through every second frame is off from the others by more than a hundredth of
## its range.  A run without states between its frames is integrated once more for that, and for the spectrum, by the
## scene's own method there and by "auto" here; where the curves would take too long, a note says so.
## @end deftypefn

function drawing = run_drawing (kind, scene, run)
  drawing = kind.drawing (scene, run);
  if (numel (drawing.time) >= 5 && numel (drawing.time) < 2000 && ! are_smooth (drawing.panels, drawing.time))
    [run, failure] = with_states_between (kind, scene, run, run.solver);
    if (isempty (failure))
      dense = between_frames (kind, scene, run);
      drawing.panels = kind.drawing (scene, dense).panels;
      drawing.panel_time = dense.history.t;
    else
      drawing.notes = [field_or(drawing, "notes", {}), ...
                       {["the curves of history.svg miss what is between frames: " failure]}];
    endif
  endif
  run = with_states_between (kind, scene, run, setfield (scene.solver, "name", "auto"));
  drawing.spectrum = kind.spectrum (scene, run);
endfunction

function [run, failure] = with_states_between (kind, scene, run, solver)
  failure = "";
  if (isfield (run, "between") || numel (run.history.t) < 2)
    return;
  endif
  try
    run.between = run_model (kind, scene, run.model, setfield (solver, "seconds", 10), run, true).between;
  catch err
    rethrow_others (err, "toolchain:integration");
    failure = strtrim (err.message);
  end_try_catch
endfunction

function dense = between_frames (kind, scene, run)
  picked = 1:max (1, round (numel (run.between.t)/2000)):numel (run.between.t);
  system = started_system (kind, scene, run.model);
  dense = kind.observe (scene, run.model, system, run.between.t(picked), run.between.states(:,picked));
  dense.model = run.model;
endfunction

## What is a thousandth of other curves of its unit, as the energy balance is, may jump.
function yes = are_smooth (panels, t)
  yes = true;
  between = 2:2:numel (t) - 1;
  for panel = panels(:).'
    alike = panels(strcmp ({panels.unit}, panel.unit));
    ranges = range (panel.values, 2);
    ranges = max (ranges, 1e-3*max (cellfun (@(values) max (range (values, 2)), {alike.values})));
    off = abs (spline (t(1:2:end), panel.values(:,1:2:end), t(between)) - panel.values(:,between));
    yes = yes && all ((off <= ranges/100)(:));
  endfor
endfunction

%!function drawing = drawn (scene)
%!  scene = check_scene (scene);
%!  run = run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)));
%!  drawing = run_drawing (rod_kind (), scene, run);
%!endfunction
%!test # a rigid rod that swings is drawn from its frames; where the paper's rod rings, its highest energies are seen
%! scene = setfield (setfield (swing (), "duration", 1), "model", "modes", [0 0]);
%! assert (isfield (drawn (scene), "panel_time"), false);
%! scene = setfield (setfield (setfield (paper (), "model", "modes", [0 4]), "duration", 0.6), "frames_per_second", 20);
%! rings = drawn (scene);
%! assert (numel (rings.panel_time), 2000, 200); assert (columns (rings.panels(1).values), numel (rings.panel_time));
%!test # as they are where frames are as dense
%! scene = setfield (setfield (setfield (paper (), "model", "modes", [0 2]), "duration", 0.6), "frames_per_second", 20);
%! scene = check_scene (scene);
%! run = run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)));
%! curves = run_drawing (rod_kind (), scene, run);
%! dense = rod_panels (dense_run (rod_kind (), scene, run, 20000).history, undeformed_tip (run.model));
%! for k = 1:numel (dense) - 1
%!   values = interp1 (0:5e-5:0.6, dense(k).values.', curves.panel_time, "spline").';
%!   assert (curves.panels(k).values, values, 1e-4*max (range (values, 2)));
%! endfor
%!test # nothing is drawn again where the run would take too long
%! scene = setfield (setfield (paper (), "model", "modes", [0 4]), "duration", 0.6);
%! scene = check_scene (setfield (scene, "frames_per_second", 20));
%! run = run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)));
%! slow = setfield (rod_kind (), "system", @(varargin) error ("toolchain:integration", "given up after 10 s\n"));
%! slow.drawing = @(scene, run) rmfield (rod_drawing (scene, run.model, run.history), "notes");
%! drawing = run_drawing (slow, scene, run);
%! assert (drawing.spectrum, []);
%! assert (drawing.notes{end}, "the curves of history.svg miss what is between frames: given up after 10 s");
%!function spectrum = of_struck_rod (solver, duration)   # hinged, a mechanism, of one mode, whose curves look smooth
%!  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 1), ...
%!                         "initial", struct ("V2", 1e-3), "model", struct ("modes", [0 1]))};
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%!  [scene.duration, scene.gravity, scene.solver] = deal (duration, 0, struct ("name", solver, "tolerance", 1e-4));
%!  result = driver (scene, "output", "");
%!  drawing = struct ("time", 1:5, "panels", new_panel ("smooth", "m", {"x"}, 1:5));
%!  kind = setfield (mechanism_kind (), "drawing", @(scene, run) drawing);
%!  spectrum = run_drawing (kind, result.scene, result).spectrum;
%!endfunction
%!test # a mechanism has a spectrum by whatever method
%! spectrum = of_struck_rod ("projection", 0.5);
%! [largest, k] = max (spectrum.values(2,:));
%! assert (spectrum.frequency(k), sqrt (pi^4*100/(1 - 6/pi^2))/(2*pi), 2/0.5);
%!assert (of_struck_rod ("radau", 0.01), [])  # one frame
