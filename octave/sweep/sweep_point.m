## -*- texinfo -*-
## @deftypefn {} {} sweep_point (@var{scene}, @var{option}, @var{value}, @dots{})
## Run one point of a sweep, that of the option "at", without it the scene as it is, and leave what "observe" asks for:
## options as for @code{sweep}, and "point", the key by which the folder "output" then has it, a file of these names
## with the ending
##
## @table @code
## @item row
## the observed numbers and texts, a line each
## @item failed
## the message of a run that failed, which is this command's error, too
## @end table
##
## With "keep", the tables of the run are in a folder of that name; with "pictures", all its files.
## Without "point" the values are printed, and the run's files are in the folder "output" where that is stated.
## @end deftypefn

function sweep_point (which, varargin)
  [settings, options] = take_settings (varargin);
  items = read_observe (settings.observe);
  [~, output] = take_options (struct (), "", options);
  names = strcat (settings.point, {".row", ".failed"});
  if (isempty (settings.point))
    cellfun (@(line) say ("%s", line), observe_run (which, settings, options, items, output.folder));
    return;
  endif
  place = "";
  if (settings.keep || output.pictures)
    place = fullfile (output.folder, settings.point);
  endif
  try
    lines = observe_run (which, settings, options, items, place);
    leave (names{1}, sprintf ("%s\n", lines{:}));
  catch err
    leave (names{2}, [point_message(err) "\n"]);
    rethrow (err);
  end_try_catch

  function leave (name, text)
    publish_run (output.folder, names, @(aside) write_text (fullfile (aside, name), text));
  endfunction
endfunction

## the observed values, a text each, of a run that leaves its files in a place
function lines = observe_run (which, settings, options, items, place)
  [columns, values] = stated_point (settings);
  [scene, output] = scene_at (which, options, columns, values);
  tables = verb_tables (scene, {items.part}, false, {"exact", true}(1:2*isequal (output.exact, true)));
  [names, table] = deal ({}, []);
  if (! isempty (place) || ! all (ismember ({items.part}, {"modes", "statics"})))
    [names, table, run] = run_of (scene, output, place, typed (which, settings, options));
    tables.summary = run.summary;
    if (any (strcmp ({items.part}, "truth")))
      tables.truth = true_figures (run);
    endif
  endif
  observed = @(item) text_of (observed_value (item, names, table, tables));
  lines = arrayfun (observed, items, "uniformoutput", false);
endfunction

function [names, table, run] = run_of (scene, output, place, command)
  exact = output.exact;
  if (isempty (exact))
    exact = false;  # all rows have the columns of one kind
  endif
  run = driver (scene, "output", place, "pictures", output.pictures, "command", command, "exact", exact);
  kind = kind_of (run.scene);
  [names, table] = kind.columns (run.scene, run);
endfunction

## what to type for the same run, wherever its files go
function command = typed (which, settings, options)
  options = without_options (options, {"output", "pictures"});
  if (! isempty (settings.at))
    options = [options, {"at", settings.at}];
  endif
  options = [options, {"observe", settings.observe}];
  command = repeat_command (nthargout (3, @find_scene, which), options, "make point");
endfunction

function text = text_of (value)
  text = value;
  if (! ischar (value))
    text = sprintf ("%.17g", value);
  endif
endfunction

%!function found = run_point (folder, varargin)
%!  found = {"", {}};
%!  point = {"output", folder, "pictures", false, "point", "k"};
%!  try
%!    sweep_point ("swing", "modes", [0 0], "solver", "rk4", point{:}, varargin{:});
%!  catch err
%!    found{1} = strtrim (err.message);
%!  end_try_catch
%!  found{2} = setdiff ({dir(folder).name}, {".", "..", "scratch"});
%!  found(3:4) = cellfun (@(name) read (fullfile (folder, ["k" name])), {".row", ".failed"}, "uniformoutput", false);
%!endfunction
%!function text = read (file)
%!  text = "";
%!  if (exist (file, "file"))
%!    text = fileread (file);
%!  endif
%!endfunction
%!function check (folder)
%!  point = {"at", "duration=0.1; solver.step=0.001; solver.tolerance=1e-4"};
%!  bad = run_point (folder, "at", "duration=0.1; solver.step=0.5; solver.tolerance=-1", "observe", "last phi");
%!  assert (bad, {"solver.tolerance is -1: it takes \"pixel\" or positive number in m", {"k.failed"}, "", ...
%!                "solver.tolerance is -1: it takes \"pixel\" or positive number in m\n"});
%!  good = run_point (folder, point{:}, "observe", "model, last t, estimated_error_m");
%!  assert (good, {"", {"k.row"}, "rigid\n0.10000000000000001\nNaN\n", ""});
%!  kept = run_point (folder, point{:}, "observe", "last t", "keep", true);
%!  assert (kept(2), {{"k", "k.row"}});
%!  assert (ismember ({"history.csv", "summary.json", "report.html"}, {dir(fullfile (folder, "k")).name}), ...
%!          [true true false]);
%!endfunction
%!test # the row of a run, or the message of one that failed, in the place of the other; files where they are kept
%! evalc ("in_scratch (@(folder, scratch) check (folder));");
%!test # without a key a person sees the values
%! said = evalc ("sweep_point ('swing', 'at', 'duration=0.1', 'modes', [0 0], 'observe', 'last t, model');");
%! assert (strsplit (strtrim (said), "\n"){end}, "rigid");
%!test # without AT it is the scene as it is
%! said = evalc ("sweep_point ('swing', 'modes', [0 0], 'observe', 'last t');");
%! assert (str2double (strsplit (strtrim (said), "\n"){end}), swing ().duration);
%!test # of modes and equilibrium, without a run
%! said = evalc ("sweep_point ('swing', 'at', 'rod.length=0.5', 'observe', 'modes.f(1), statics.tip_y');");
%! found = str2double (strsplit (strtrim (said), "\n")(end-1:end));
%! assert (found, [sqrt(1.5*9.81/0.5)/(2*pi), -0.5], -0.01);
%! assert (isempty (strfind (said, "integration")));
%!function check_typed (folder)
%!  sweep_point ("swing", "at", "duration=0.1", "modes", [0 0], "observe", "model", "pictures", false, ...
%!               "output", folder);
%!  assert (jsondecode (fileread (fullfile (folder, "summary.json"))).command, ...
%!          "make point SCENE=swing MODES='0 0' AT='duration=0.1' OBSERVE=model");
%!endfunction
%!test # its files, where it is said where, and in them what to type
%! evalc ("in_scratch (@(folder, scratch) check_typed (folder));");
%!test # with the geometrically exact rod
%! text = evalc ("sweep_point ('swing', 'at', 'duration=0.05', 'observe', 'model', 'exact', true, 'output', '')");
%! assert (! isempty (strfind (text, "geometrically exact")), text);
%!test # the true error, by a far richer run: what a rigid rod misses here is little, and not nothing
%! said = evalc ("sweep_point ('swing', 'at', 'duration=0.05', 'modes', [0 0], 'observe', 'truth.error_m');");
%! missed = str2double (strsplit (strtrim (said), "\n"){end});
%! assert (missed > 1e-9 && missed < 1e-5);
