## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} run_drawing (@var{kind}, @var{scene}, @var{run})
## What the pictures of a @var{run} show (see @code{draw_pictures}): the drawing of its @var{kind} and the spectrum.
## The panels of @file{history.svg} are from some 2000 times of the run, panel_time, where the frames' samples miss
## what is between them: where a curve through the frames is off from states between them by more than a hundredth of
## its range.  A run without states between its frames is integrated once more for that, and for the spectrum, by
## "auto", and by the scene's own method where its curves are drawn; where that would take too long, a note says so.
## @end deftypefn

function drawing = run_drawing (kind, scene, run)
  drawing = kind.drawing (scene, run);
  drawing.panels = kind.panels (scene, run);
  auto = setfield (scene.solver, "name", "auto");
  if (strcmp (run.solver.name, "auto"))
    auto = run.solver;
  endif
  [by_auto, failure] = with_states_between (kind, scene, run, auto);
  if (numel (drawing.time) < 2000 && ! are_smooth (kind, scene, drawing, by_auto))
    if (strcmp (run.solver.name, "auto"))
      run = by_auto;
    else
      [run, failure] = with_states_between (kind, scene, run, run.solver);
    endif
    if (isempty (failure))
      dense = between_frames (kind, scene, run, 1:max (1, round (numel (run.between.t)/2000)):numel (run.between.t));
      drawing.panels = kind.panels (scene, dense);
      drawing.panel_time = dense.history.t;
    else
      drawing.notes = [field_or(drawing, "notes", {}), ...
                       {["the curves of history.svg miss what is between frames: " failure]}];
    endif
  endif
  drawing.spectrum = kind.spectrum (scene, by_auto);
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

function dense = between_frames (kind, scene, run, picked)
  system = started_system (kind, scene, run.model);
  dense = kind.observe (scene, run.model, system, run.between.t(picked), run.between.states(:,picked));
  dense.model = run.model;
endfunction

## What is a thousandth of other curves of its unit, as the energy balance is, may jump.  A run that cannot be looked at
## between its frames is not smooth.
function yes = are_smooth (kind, scene, drawing, run)
  yes = numel (drawing.time) < 2;
  if (yes || ! isfield (run, "between"))
    return;
  endif
  picked = unique (ceil (numel (run.between.t)*mod ((1:60)*(sqrt (5) - 1)/2, 1)));  # in no rhythm of the frames
  there = between_frames (kind, scene, run, picked);
  panels = kind.panels (scene, there);
  yes = isequal ({drawing.panels.names}, {panels.names});  # curves that are near to zero are left out
  if (! yes)
    return;
  endif
  for k = 1:numel (drawing.panels)
    alike = strcmp ({drawing.panels.unit}, drawing.panels(k).unit);
    range_of = @(k) range ([drawing.panels(k).values, panels(k).values], 2);
    ranges = max (range_of (k), 1e-3*max (arrayfun (@(k) max (range_of (k)), find (alike))));
    off = abs (spline (drawing.time, drawing.panels(k).values, there.history.t) - panels(k).values);
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
%!test # what its frames see at the same phase each time, and what few frames pass over
%! scene = setfield (setfield (swing (), "model", "modes", [0 0]), "duration", 20);
%! period = 2*pi*sqrt (2*scene.rod.length/(3*9.81))*1.18;  # of a swing from the horizontal
%! for rate = [1/period, 0.1]
%!   seen = drawn (setfield (scene, "frames_per_second", rate));
%!   assert (numel (seen.panel_time) > 500);
%! endfor
%!test # modes that only some times show: a cantilever, bent and pushed
%! scene = setfield (setfield (swing (), "model", "modes", [0 2]), "rotation", @(t) [0 0 0]);
%! [scene.duration, scene.frames_per_second] = deal (0.01, 200);
%! scene.initial.V2 = [1e-3 0];
%! kind = rod_kind ();
%! kind.panels = @(scene, run) new_panel ("modes", "m", {"1", "2"}(1:1 + (numel (run.history.t) < 9)), ...
%!                                        repmat (run.history.t, 1 + (numel (run.history.t) < 9), 1));
%! scene = check_scene (scene);
%! run = run_model (kind, scene, build_model (scene, rung_of_scene (scene)));
%! assert (run_drawing (kind, scene, run).panels.names, {"1"});
%!function spectrum = of_struck_rod (solver, duration)   # hinged, a mechanism, of one mode, whose curves look smooth
%!  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 100, "rhoA", 1), ...
%!                         "initial", struct ("V2", 1e-3), "model", struct ("modes", [0 1]))};
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%!  [scene.duration, scene.gravity, scene.solver] = deal (duration, 0, struct ("name", solver, "tolerance", 1e-4));
%!  result = driver (scene, "output", "");
%!  kind = setfield (mechanism_kind (), "drawing", @(scene, run) struct ("time", run.history.t));
%!  kind.panels = @(scene, run) new_panel ("smooth", "m", {"x"}, run.history.t);
%!  spectrum = run_drawing (kind, result.scene, result).spectrum;
%!endfunction
%!test # a mechanism has a spectrum by whatever method
%! spectrum = of_struck_rod ("projection", 0.5);
%! [largest, k] = max (spectrum.values(2,:));
%! assert (spectrum.frequency(k), sqrt (pi^4*100/(1 - 6/pi^2))/(2*pi), 2/0.5);
%!assert (of_struck_rod ("radau", 0.01), [])  # one frame
