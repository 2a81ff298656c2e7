## -*- texinfo -*-
## @deftypefn {} {@var{command} =} engine_command (@var{engine}, @var{jobs}, @var{settings}, @var{folder}, @
##   @var{names}, @var{commands}, @var{gather})
## What distributes the @var{commands} (cellstr) among so many @var{jobs} at a time, within the limits of load, memory
## and time and on the hosts of the @var{settings} (see @code{sweep_settings}): a shell command for the @var{folder},
## in which their list is written, each under its name of @var{names}.  The @var{engine} is "parallel", GNU parallel,
## with the list of what ended when and how in joblog; "make", which is always there; or "slurm", an array of at most
## 1000 tasks in Slurm's queue (for which the user's SBATCH_ variables hold: partition, time, memory), and the command
## @var{gather} behind them all, in a job that depends on theirs.  None stops at a point that fails.  A task that Slurm
## puts back into the queue begins at its first point that has no row.
## @end deftypefn

function command = engine_command (engine, jobs, settings, folder, names, commands, gather = "")
  of_make_sweep = [{"MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES"}, toupper(sweep_settings ()(:,1)).'];
  clean = sprintf ("unset %s; export QUIET=1; ", strjoin (of_make_sweep, " "));
  put = @(name, template, varargin) write_text (fullfile (folder, name), sprintf (template, varargin{:}));
  lines = [names; commands];
  ## an engine goes when who waits for it has gone, whatever ended that
  goes_with = sprintf ("( ( while kill -0 %d; do sleep 1; kill -0 $$ || exit; done; kill $$ ) >/dev/null 2>&1 & ); ", ...
                       getpid ());
  switch (engine)
    case "parallel"
      put ("commands", "%s\n", commands{:});
      command = [goes_with, "PARALLEL_HOME=$PWD PARALLEL_SHELL=/bin/sh exec parallel --plain --will-cite --joblog joblog", ...
                 " --arg-file commands", option(" --jobs %d", jobs(isfinite (jobs))), ...
                 option(" --load %g", settings.load), option(" --memfree %s", settings.memory)];
      if (! isempty (settings.hosts))
        command = [command " --env QUIET --sshlogin " shell_string(settings.hosts)];
      endif
    case "make"
      every = strjoin (names, " ");
      rules = sprintf ("%s:\n\t@%s\n", strrep (lines, "$", "$$"){:});
      put ("commands", ".PHONY: all %s\nall: %s\n%s", every, every, rules);
      command = [goes_with, sprintf("exec make -s -k -j %d -f commands", jobs), option(" -l %g", settings.load)];
    case "slurm"
      tasks = min (numel (names), 1000);
      put ("commands", "[ -e ../points/%s.row ] || %s\n", lines{:});
      put ("task", ["#!/bin/sh\nexec sh -c" ...
                    " \"$(awk -v n=%d -v k=$SLURM_ARRAY_TASK_ID '(NR - k) %% n == 0' commands)\"\n"], tasks);
      put ("gather", "#!/bin/sh\n%s\n", gather);
      range = sprintf ("1-%d", tasks);
      if (isfinite (jobs))
        range = sprintf ("%s%%%d", range, jobs);
      endif
      minutes = ceil (ceil (numel (names)/tasks)*(settings.time_limit + 1)/60);
      limits = [option(" --mem=%s", settings.memory), option(" --time=%d", minutes)];
      command = ["array=$(sbatch --parsable --requeue --output=/dev/null" limits " --array=" range " task) &&" ...
                 " exec sbatch --wait --output=/dev/null --dependency=\"afterany:${array%%;*}\" gather"];
  endswitch
  command = [clean command];
endfunction

## nothing where there is no value
function text = option (template, value)
  text = "";
  if (! isempty (value))
    text = sprintf (template, value);
  endif
endfunction

%!function said = run_all (folder, engine, commands)
%!  names = arrayfun (@(k) sprintf ("p%d", k), 1:numel (commands), "uniformoutput", false);
%!  command = engine_command (engine, 2, take_settings ({}), folder, names, commands);
%!  [~, ~] = system (["cd '" folder "' && " command " >/dev/null 2>&1"]);
%!  said = fileread (fullfile (folder, "said"));
%!endfunction
%!function check (engine)
%!  commands = {"echo 1 >>said", "false", "echo '$a' \"it's #\" >>said"};
%!  said = in_scratch (@(folder, scratch) run_all (folder, engine, commands));
%!  assert (sort (strsplit (strtrim (said), "\n")), {"$a it's #", "1"});
%!endfunction
%!test # all of them, beside one that fails, by what is here
%! for engine = unique ({"make", engine_here(take_settings ({"jobs", 2}))})
%!   check (engine{1});
%! endfor
%!function said = limited (folder, engine, varargin)
%!  settings = take_settings (varargin);
%!  said = engine_command (engine, 2, settings, folder, {"p1"}, {"true"}, "true");
%!endfunction
%!test # limits and hosts, where they are stated
%! of = @(varargin) in_scratch (@(folder, scratch) limited (folder, varargin{:}));
%! has = @(text, words) ! isempty (strfind (text, words));
%! assert (has (of ("parallel"), "--arg-file commands --jobs 2")); assert (has (of ("parallel"), "sshlogin"), false);
%! assert (has (of ("parallel", "load", 1.5, "memory", "2G"), " --load 1.5 --memfree 2G"));
%! assert (has (of ("parallel", "hosts", "a,2/b"), " --env QUIET --sshlogin 'a,2/b'"));
%! assert (has (of ("make", "load", 1.5), "exec make -s -k -j 2 -f commands -l 1.5"));
%! assert (has (of ("slurm", "memory", "2G", "time_limit", 100), "--output=/dev/null --mem=2G --time=2 --array"));
%!function said = of_many (folder, count)   # points, each within 100 s
%!  names = arrayfun (@(k) sprintf ("p%d", k), 1:count, "uniformoutput", false);
%!  said = engine_command ("slurm", 2, take_settings ({"time_limit", 100}), folder, names, names, "true");
%!endfunction
%!test # a task of Slurm's array has the time of all its points: three of 2500
%! text = in_scratch (@(folder, scratch) of_many (folder, 2500));
%! assert (! isempty (strfind (text, sprintf (" --time=%d --array=1-1000%%2 ", ceil (3*101/60)))), text);
