## -*- texinfo -*-
## @deftypefn {} {@var{result} =} driver (@var{scene}, @var{option}, @var{value}, @dots{})
## Simulate a scene and leave history, summary, frames, film and figures: the whole way from a scene to its pictures.
##
## @var{scene} is the name of a function in octave/scenes/ (default "paper"), the path of a function file of one's own,
## or a struct; `help scene_fields' lists its fields.  The options stand for fields of the scene: "modes" ([N1 N2] or
## "auto"), "solver" (a name), "tolerance" (m, or "pixel"), "size" ([W H] of a frame in pixels); "output" is the folder
## to write into (default output/NAME; "" writes nothing), and "pictures" (true or false) says whether there are to be
## more than history.csv and summary.json.
##
## @var{result}, where it is asked for, has the fields scene, model, history and summary; of a scene of several bodies
## it is what @code{simulate_mechanism} returns.
##
## @example
## result = driver ("paper", "modes", [0 4], "solver", "ode45", "tolerance", 1e-6);
## @end example
## @end deftypefn

function result = driver (scene = "paper", varargin)
  found = run_scene (scene, varargin);
  if (nargout > 0)
    result = found;
  endif
endfunction

function result = run_scene (scene, options)
  start = tic ();
  command = repeat_command (scene, options);
  [scene, name] = load_scene (scene);
  [scene, output] = take_options (scene, fullfile ("output", name), options);
  if (isfield (scene, "surface"))
    result = drive_surface (scene, name, output, command);
    return;
  elseif (isfield (scene, "bodies"))
    result = simulate_mechanism (scene, name, output, command);
    return;
  endif
  scene = check_scene (scene);
  announce_breaks (scene.probed);
  if (isempty (scene.title))
    scene.title = name;
  endif
  scene.solver.tolerance = tolerance_in_metres (scene);
  prepare_output (output, scene);

  try
    [model, choice] = model_of_scene (scene);
    announce (choice);
    cellfun (@(text) say ("warning: %s", text), spin_warning (scene, model));
    [history, count] = run_model (scene, model, choice);
  catch err
    record_failure (output, name, scene, err);
    rethrow (err);
  end_try_catch
  summary = summarise (name, scene, model, choice, count, history);
  summary.command = command;
  summary = write_run (output, scene, summary, start, @(file) write_history (history, file), ...
                       @() with_spectrum (rod_drawing (scene, model, history), scene, model));
  result = struct ("scene", scene, "model", model, "history", history, "summary", summary);
endfunction

function drawing = with_spectrum (drawing, scene, model)
  drawing.spectrum = tip_spectrum (scene, model);
endfunction

%!test # a short run without files
%! result = driver ("paper", "modes", [0 0], "output", "");
%! assert (numel (result.history.t), 91);
%! assert (result.history.t(end), 1.8);
%! assert (result.summary.method, "waveform");
%!error <model.modes is "many": it takes "auto" or two numbers of modes \[N1 N2\]> driver ("paper", "modes", "many")
%!error <"speed" is not an option: those are modes, solver, tolerance, size, output, pictures>
%! driver ("paper", "speed", 3);
