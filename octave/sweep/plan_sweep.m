## -*- texinfo -*-
## @deftypefn {} {@var{plan} =} plan_sweep (@var{which}, @var{options})
## What a sweep of the scene @var{which} with these @var{options} (a cell array, see @code{sweep}) is to do, before
## anything is run or written.
##
## @var{plan} is a struct of name, file and typed, the scene's; studied, whether points run studies; call, what to type
## for the sweep; settings (see @code{sweep_settings}); folder, where its files go; pictures, whether the whole is
## drawn; columns and values (see @code{sweep_table}); items (see @code{read_observe}); about, what all points have in
## common, a text by name; keys (cellstr, see @code{point_keys}); command (k), what runs the k-th point; and done,
## whether its row is there.
## @end deftypefn

function plan = plan_sweep (which, options)
  if (isstruct (which))
    scene_error ("a sweep takes a scene by its name or its file, not a struct: its points are processes of their own");
  endif
  [plan.file, ~, plan.typed] = find_scene (which);
  plan.call = call_of (plan.typed, options);
  [settings, options] = take_settings (options);
  plan.settings = settings;
  [~, plan.name] = fileparts (plan.file);
  [~, output] = take_options (struct (), fullfile ("output", plan.name, "sweep"), options);
  plan.folder = output.folder;
  plan.pictures = output.pictures;
  plan.items = read_observe (settings.observe);
  [plan.columns, plan.values] = sweep_table (settings);
  plan.options = sorted_pairs (without_options (options, {"output", "pictures"}));
  plan.drawn = output.pictures && any (strcmp (options(1:2:end), "pictures"));
  plan.studied = any (ismember ({plan.items.part}, {"modes", "statics", "truth"}));
  plan.about = struct ("program", program_key (plan.studied), "scene", hash ("sha256", fileread (plan.file))(1:16), ...
                       "options", repeat_command (plan.typed, plan.options), ...
                       "observe", strjoin ({plan.items.text}, ", "));
  plan.keys = point_keys (strjoin (struct2cell (plan.about), "\n"), plan.columns, plan.values);
  plan.done = are_done (plan);
  plan.command = @(k) command_of (plan, plan.keys{k}, plan.values(k,:));
endfunction

## a table in Octave has no words for a shell
function call = call_of (typed, options)
  [others, table] = without_options (options, "table");
  if (isempty (table))
    call = repeat_command (typed, options, "make sweep");
  else
    call = ["sweep (\"" typed "\", table" repeat_command(struct (), others)(numel ("driver (scene") + 1:end)];
  endif
endfunction

## the same options are the same, in whatever order
function options = sorted_pairs (options)
  [~, order] = sort (options(1:2:end));
  options = reshape (options([2*order - 1; 2*order]), 1, []);
endfunction

function command = command_of (plan, key, values)
  root = fileparts (fileparts (which ("driver")));
  given = {"at", point_words(plan.columns, values), "observe", plan.about.observe, "keep", plan.settings.keep, ...
           "pictures", plan.drawn, "output", fullfile(make_absolute_filename (plan.folder), "points"), "point", key};
  command = repeat_command (plan.typed, [plan.options, given], ["make -s -C " shell_string(root) " point"]);
  if (! isempty (plan.settings.time_limit))
    limit = sprintf ("%.15g", plan.settings.time_limit);
    failed = shell_string (fullfile (given{end-2}, [key ".failed"]));
    command = ["timeout " limit " " command " || { [ $? != 124 ] ||" ...
               " echo it took longer than TIME_LIMIT=" limit " s >" failed "; false; }"];
  endif
endfunction

## A row is there, and where runs are to be kept, the run.
function done = are_done (plan)
  points = fullfile (plan.folder, "points");
  done = cellfun (@(key) exist (fullfile (points, [key ".row"]), "file") > 0, plan.keys);
  if (plan.settings.keep || plan.drawn)
    done &= cellfun (@(key) exist (fullfile (points, key, "summary.json"), "file") > 0, plan.keys);
  endif
endfunction

%!function check (folder)
%!  plan = @(varargin) plan_sweep ("chain(3)", [{"output", fullfile(folder, "it's $x"), "jobs", 2}, varargin]);
%!  first = plan ("vary", "argument.1=2,3", "tolerance", 1e-3, "observe", "model");
%!  assert ({first.name, first.typed, first.pictures, first.drawn, first.done}, ...
%!          {"chain", "chain(3)", true, false, [false false]});
%!  assert (! isempty (strfind (first.call, "make sweep SCENE='chain(3)' OUTPUT=")));
%!  assert (! isempty (strfind (first.call, "JOBS=2 VARY='argument.1=2,3' TOLERANCE=0.001 OBSERVE=model")));
%!  assert (plan_sweep ("swing", {"table", {"zoom"; 1}, "jobs", 2}).call, "sweep (\"swing\", table, \"jobs\", 2)");
%!  command = first.command (2);
%!  assert (! isempty (strfind (command, " point SCENE='chain(3)' TOLERANCE=0.001 AT='argument.1=3' OBSERVE=model ")));
%!  assert (! isempty (strfind (command, ["/it'\\''s $x/points' POINT=" first.keys{2}])));
%!  limited = plan ("vary", "argument.1=2,3", "tolerance", 1e-3, "observe", "model", "time_limit", 0.1);
%!  assert (limited.keys, first.keys);
%!  mkdir (fullfile (limited.folder, "points")); long = regexprep (limited.command (2), "make .*? \\|\\|", "sleep 9 ||");
%!  assert (system (long) != 0);
%!  assert (fileread (fullfile (limited.folder, "points", [first.keys{2} ".failed"])), ...
%!          "it took longer than TIME_LIMIT=0.1 s\n");
%!  keys = @(varargin) plan ("vary", "argument.1=2,3", varargin{:}).keys;
%!  assert (keys ("tolerance", 1e-3, "observe", "model", "jobs", 1, "engine", "make", "keep", true), first.keys);
%!  studies = @(observe) plan ("vary", "argument.1=2,3", "observe", observe).about.program;
%!  assert (strcmp (studies ("model"), {studies("frames"), studies("model, modes.f(1)")}), [true false]);
%!  others = {{"observe", "model"}, {"tolerance", 1e-3}, {"tolerance", 1e-3, "observe", "model", "modes", [0 1]}};
%!  for other = others
%!    assert (isempty (intersect (keys (other{1}{:}), first.keys)));
%!  endfor
%!  points = fullfile (folder, "it's $x", "points");
%!  write_text (fullfile (points, [first.keys{2} ".row"]), "1\n");
%!  given = {"vary", "argument.1=2,3", "tolerance", 1e-3, "observe", "model"};
%!  assert (plan (given{:}).done, [false true]); assert (plan (given{:}, "keep", true).done, [false false]);
%!  mkdir (points, first.keys{2}); write_text (fullfile (points, first.keys{2}, "summary.json"), "{}");
%!  assert (plan (given{:}, "keep", true).done, [false true]);
%!  assert (plan (given{:}, "pictures", true).drawn); assert (plan (given{:}, "pictures", false).drawn, false);
%!endfunction
%!test in_scratch (@(folder, scratch) check (folder));
%!error <a sweep takes a scene by its name or its file, not a struct> plan_sweep (struct (), {"vary", "a=1"})
%!error <no scene "nowhere"> plan_sweep ("nowhere", {"vary", "a=1"})
