## -*- texinfo -*-
## @deftypefn {} {@var{command} =} gather_command (@var{plan}, @var{folder})
## What makes the table of a @var{plan} (see @code{plan_sweep}) of the rows that are there, and runs nothing: a shell
## command, which reads the points from a file that is written into the @var{folder}, or has the ranges of random ones.
## @end deftypefn

function command = gather_command (plan, folder)
  words = cellfun (@value_words, plan.values, "uniformoutput", false);
  lines = cellfun (@(row) strjoin (row, ","), num2cell ([plan.columns; words], 2), "uniformoutput", false);
  file = fullfile (make_absolute_filename (folder), "points.csv");
  write_text (file, sprintf ("%s\n", lines{:}));
  pictures = {};
  if (plan.drawn || ! plan.pictures)
    pictures = {"pictures", plan.pictures};
  endif
  points = {"over", file};
  if (! isempty (plan.settings.random))
    points = {"vary", plan.settings.vary, "random", plan.settings.random, "seed", plan.settings.seed};
  endif
  given = [points, {"observe", plan.about.observe, "keep", plan.settings.keep}, pictures, ...
           {"output", make_absolute_filename(plan.folder), "gather", true}];
  root = fileparts (fileparts (which ("driver")));
  command = repeat_command (plan.typed, [plan.options, given], ["make -s -C " shell_string(root) " sweep"]);
endfunction

%!function check (folder, scratch)
%!  given = {"vary", "argument.1=2,3; model.modes=0 1,0 2", "solver", "radau", "tolerance", 1/3, "observe", "model"};
%!  plan = plan_sweep ("chain", [given, {"output", folder, "pictures", false}]);
%!  command = gather_command (plan, scratch);
%!  assert (! isempty (strfind (command, "PICTURES=no"))); assert (! isempty (strfind (command, "GATHER=yes")));
%!  again = plan_sweep ("chain", {"over", fullfile(scratch, "points.csv"), "tolerance", 0.333333333333333, ...
%!                                "solver", "radau", "observe", "model"});
%!  assert (again.keys, plan.keys);
%!  random = plan_sweep ("chain", {"vary", "duration=0.1..0.3", "random", 4, "seed", 5, "output", folder});
%!  assert (! isempty (strfind (gather_command (random, scratch), "VARY='duration=0.1..0.3' RANDOM=4 SEED=5 ")));
%!  assert (system ([command " >/dev/null"]), 0);
%!  json = jsondecode (fileread (fullfile (folder, "sweep.json")));
%!  assert ([json.points, json.done, json.failed, json.missing], [4 0 0 4]);
%!endfunction
%!test in_scratch (@check);   # the same points, from whatever they came, and none is run
