## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} with_dense_curves (@var{drawing}, @var{kind}, @var{scene}, @var{run})
## The @var{drawing} of a @var{run} (see @code{draw_pictures}), with the panels of @file{history.svg} from 2000 times
## of the run, panel_time, where the frames' samples miss what is between them: where a curve through every second
## frame is off from the others by more than a hundredth of its range.  Where it would take too long, a note says so.
## @end deftypefn

function drawing = with_dense_curves (drawing, kind, scene, run)
  rate = ceil (2000/scene.duration);
  if (rate <= scene.frames_per_second || numel (drawing.time) < 5 || are_smooth (drawing.panels, drawing.time))
    return;
  endif
  try
    dense = dense_run (kind, scene, run, rate, 10);
  catch err
    if (! strcmp (err.identifier, "toolchain:integration"))
      rethrow (err);
    endif
    drawing.notes{end+1} = sprintf ("the curves of history.svg miss what is between frames: %s", strtrim (err.message));
    return;
  end_try_catch
  curves = kind.drawing (scene, dense);
  drawing.panels = curves.panels;
  drawing.panel_time = curves.time;
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
%!  drawing = with_dense_curves (rod_drawing (scene, run.model, run.history), rod_kind (), scene, run);
%!endfunction
%!test # a rigid rod that swings is drawn from its frames; where the paper's rod rings, its highest energies are seen
%! scene = setfield (setfield (swing (), "duration", 1), "model", "modes", [0 0]);
%! assert (isfield (drawn (scene), "panel_time"), false);
%! scene = setfield (setfield (setfield (paper (), "model", "modes", [0 4]), "duration", 0.6), "frames_per_second", 20);
%! rings = drawn (scene);
%! assert (numel (rings.panel_time), 2001); assert (columns (rings.panels(1).values), 2001);
%!test # nothing is drawn again where the run would take too long
%! scene = setfield (setfield (paper (), "model", "modes", [0 4]), "duration", 0.6);
%! scene = check_scene (setfield (scene, "frames_per_second", 20));
%! run = run_model (rod_kind (), scene, build_model (scene, rung_of_scene (scene)));
%! slow = setfield (rod_kind (), "system", @(varargin) error ("toolchain:integration", "given up after 10 s\n"));
%! drawing = with_dense_curves (rod_drawing (scene, run.model, run.history), slow, scene, run);
%! assert (drawing.notes{end}, "the curves of history.svg miss what is between frames: given up after 10 s");
