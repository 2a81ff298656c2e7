## -*- texinfo -*-
## @deftypefn {} {@var{result} =} driver (@var{scene}, @var{option}, @var{value}, @dots{})
## Simulate a scene and leave history, summary, frames, film and figures: the whole way from a scene to its pictures.
##
## @var{scene} is the name of a function in octave/scenes/ (default "paper"), the path of a function file of one's own,
## or a struct; `help scene_fields' lists its fields.  The options stand for fields of the scene: "modes" ([N1 N2] or
## "auto"), "solver" (a name), "tolerance" (m, or "pixel"), "size" ([W H] of a frame in pixels), "pieces" (how many
## welded ones each straight rod is made of, see @code{in_pieces}); "output" is the folder to write into (default
## output/NAME; "" writes nothing), and "pictures" (true or false) says whether there are to be more than history.csv
## and summary.json.  "dense" (1/s) adds dense.csv, a table like history.csv of so many times a second; "exact" (true,
## or "auto": where what all models drop passes the tolerance) takes geometrically exact rods,
## "auto" by default where a tolerance in metres is stated and nothing of the model; "command" is what summary.json has
## to type for the run, where that is not this call.
##
## @var{result}, where it is asked for, is the run (see @code{kind_of}) with its scene and
## summary.
##
## @example
## result = driver ("paper", "modes", [0 4], "solver", "ode45", "tolerance", 1e-6);
## @end example
## @end deftypefn

function result = driver (scene = "paper", varargin)
  start = tic ();
  [checked, kind, output, name] = checked_scene (scene, varargin);
  announce_breaks (checked.probed);
  cellfun (@(text) say ("warning: %s", text), frame_warnings (checked));
  prepare_output (output, checked);
  found = run_scene (checked, kind, output, name, @(more) repeat_command (scene, [varargin, more]), start, @() Inf);
  if (nargout > 0)
    result = found;
  endif
endfunction

## what would take longer than the seconds left is given up
function result = run_scene (scene, kind, output, name, command_with, start, left)
  by_itself = strcmp (output.exact, "auto") && ! isempty (kind.exactly (scene));
  why_not = {};
  [run, summary, unfit, err] = run_chosen (kind, scene, name, left, by_itself);
  if (by_itself && ! isempty (unfit))
    [result, why_not] = exact_run (unfit, scene, kind, output, name, command_with, start);
    if (! isempty (result))
      return;
    elseif (isempty (run) && isempty (err))
      [run, summary, ~, err] = run_chosen (kind, scene, name, left);
    endif
  endif
  if (! isempty (err))
    if (strcmp (err.identifier, "toolchain:integration:steep"))
      err = with_remedy (err, [why_not, {kind.instead(scene)}]{1});
    endif
    record_failure (output, name, scene, err);
    rethrow (err);
  endif
  summary.warnings = [summary.warnings, why_not];
  summary.command = command_with ({});
  if (! isempty (output.command))
    summary.command = output.command;
  endif
  summary = write_run (output, kind, scene, run, summary, start);
  result = run;
  result.scene = scene;
  result.summary = summary;
endfunction

## empty, with a warning, where it fails, or takes more than two minutes: the run of the model is there
function [result, why_not] = exact_run (why, scene, kind, output, name, command_with, start)
  result = [];
  why_not = {};
  say ("%s: %s: the geometrically exact rod (EXACT=no: none)", name, why);
  output.exact = true;
  began = tic ();
  try
    result = run_scene (kind.exactly (scene), kind.of_exact (scene), output, name, ...
                        @(more) command_with ([{"exact", true}, more]), start, @() 120 - toc (began));
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
    why_not = {sprintf("the geometrically exact rod could not be run: %s", strtrim (err.message))};
  end_try_catch
endfunction

%!test # a short run without files
%! result = driver ("paper", "modes", [0 0], "output", "");
%! assert (numel (result.history.t), 91);
%! assert (result.history.t(end), 1.8);
%! assert (result.summary.method, "waveform");
%!test # a last frame before the end is said first
%! said = evalc ("driver (setfield (swing (), 'duration', 0.05), 'modes', [0 0], 'output', '');");
%! assert (strncmp (said, "warning: the last frame is at 0.04 s, before the duration of 0.05 s", 67));
%!error <model.modes is "many": it takes "auto" or two numbers of modes \[N1 N2\]> driver ("paper", "modes", "many")
%!error <"speed" is not an option: those are modes, solver, tolerance, size, pieces, output, pictures, dense, exact, command>
%! driver ("paper", "speed", 3);
%!function scene = bent_rod ()
%!  scene = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.001), "gravity", 0, "duration", 0.4);
%!  scene.moment = @(t) 1.6*sin (pi*t/0.8).^2;
%!  scene.model.energy = "uniaxial";
%!endfunction
%!test # the exact rod where all other models are further off than the tolerance, and only there
%! for row = {1e-6, "auto", "exact"; 1e-3, "auto", "rod"; 1e-6, false, "rod"}.'
%!   evalc ("result = driver (bent_rod (), 'tolerance', row{1}, 'output', '', 'exact', row{2});");
%!   assert (kind_of (result.scene).name, row{3});
%! endfor
%! evalc ("result = driver (bent_rod (), 'tolerance', 1e-6, 'output', '');");  # by itself
%! assert (result.summary.estimated_error_m <= 1e-6); assert (isfield (result.history, "phi"));
%!function check_without ()
%!  evalc ("result = driver (bent_rod (), 'tolerance', 1e-6, 'output', '');");
%!  assert (kind_of (result.scene).name, "rod");
%!  said = "the geometrically exact rod could not be run: none today";
%!  assert (any (strncmp (result.summary.warnings, said, numel (said))));
%!endfunction
%!test # where it fails the model's numbers are there
%! with_stand_ins ({"system = surface_rod", "scene", "scene_error ('none today');"}, @check_without);
%!function result = clamped (varargin)   # soft, under its weight
%!  rod = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 0.1);
%!  scene.bodies = {struct("rod", rod, "model", struct ("energy", "uniaxial"), varargin{:})};
%!  scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)};
%!  [scene.duration, scene.frames_per_second] = deal (0.1, 50);
%!  scene.solver.tolerance = 1e-5;
%!  evalc ("result = driver (scene, 'output', '', 'exact', 'auto');");
%!endfunction
%!test # bodies, too, are exact where their models drop more than the tolerance, or it is said
%! result = clamped ();
%! assert (result.summary.stiffening, {"exact"}); assert (result.summary.dropped_m, 0);
%! assert (result.summary.estimated_error_m <= 1e-5);
%! result = clamped ("initial", struct ("V2", 1e-3));
%! assert (result.summary.stiffening, {"foreshortening"}); assert (result.summary.dropped_m > 1e-5);
%! assert (any (strncmp (result.summary.warnings, "the estimated error is", 22)));
