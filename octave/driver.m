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
  [found, more, err] = best_run (kind, checked, name, output.exact);
  if (! isempty (err))
    record_failure (output, name, checked, err);
    rethrow (err);
  endif
  found.summary.command = repeat_command (scene, [varargin, more]);
  if (! isempty (output.command))
    found.summary.command = output.command;
  endif
  summary = write_run (output, found.kind, found.scene, found.run, found.summary, start);
  if (nargout > 0)
    result = setfield (setfield (found.run, "scene", found.scene), "summary", summary);
  endif
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
