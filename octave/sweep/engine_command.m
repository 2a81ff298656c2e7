## -*- texinfo -*-
## @deftypefn {} {@var{command} =} engine_command (@var{engine}, @var{jobs}, @var{folder}, @var{names}, @var{commands})
## What distributes the @var{commands} (cellstr) among so many @var{jobs} at a time: a shell command for the
## @var{folder}, in which their list is written, each under its name of @var{names}.  The @var{engine} is "parallel",
## GNU parallel, with the list of what ended when and how in joblog; or "make", which is always there.  Neither stops
## at a point that fails, and neither reads settings of the user's.
## @end deftypefn

function command = engine_command (engine, jobs, folder, names, commands)
  of_make_sweep = [{"MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES"}, toupper(sweep_settings ()(:,1)).'];
  clean = sprintf ("unset %s; export QUIET=1; ", strjoin (of_make_sweep, " "));
  switch (engine)
    case "parallel"
      write_text (fullfile (folder, "commands"), sprintf ("%s\n", commands{:}));
      command = sprintf ([clean "PARALLEL_HOME=$PWD PARALLEL_SHELL=/bin/sh exec parallel --plain --will-cite" ...
                          " --jobs %d --joblog joblog --arg-file commands"], jobs);
    case "make"
      rules = [names; strrep(commands, "$", "$$")];
      write_text (fullfile (folder, "commands"), [sprintf(".PHONY: all %s\n", strjoin (names, " ")), ...
                                                  "all: ", strjoin(names, " "), "\n", ...
                                                  sprintf("%s:\n\t@%s\n", rules{:})]);
      command = sprintf ([clean "exec make -s -k -j %d -f commands"], jobs);
  endswitch
endfunction

%!function said = run_all (folder, engine, commands)
%!  names = arrayfun (@(k) sprintf ("p%d", k), 1:numel (commands), "uniformoutput", false);
%!  command = engine_command (engine, 2, folder, names, commands);
%!  [~, ~] = system (["cd '" folder "' && " command " >/dev/null 2>&1"]);
%!  said = fileread (fullfile (folder, "said"));
%!endfunction
%!function check (engine)
%!  commands = {"echo 1 >>said", "false", "echo '$a' \"it's #\" >>said"};
%!  said = in_scratch (@(folder, scratch) run_all (folder, engine, commands));
%!  assert (sort (strsplit (strtrim (said), "\n")), {"$a it's #", "1"});
%!endfunction
%!test check ("make")  # all of them, beside one that fails
%!testif ; system ("parallel --version 2>/dev/null | grep -q '^GNU parallel'") == 0
%! check ("parallel");
