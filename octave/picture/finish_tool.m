## -*- texinfo -*-
## @deftypefn {} {} finish_tool (@var{job})
## Wait for the end of a @var{job} of @code{start_tool}. It is an error when it failed: one line with the name of the
## tool and the last line that was printed.
## @end deftypefn

function finish_tool (job)
  [~, status] = waitpid (job.pid);
  said = "";
  if (exist (job.log, "file"))
    said = fileread (job.log);
    unlink (job.log);
  endif
  if (status != 0)
    last = strtrim (strsplit (strtrim (said), "\n"){end});
    if (WIFSIGNALED (status))
      error ("toolchain:scene", "%s was ended by signal %d: %s\n", job.tool, WTERMSIG (status), last);
    elseif (WEXITSTATUS (status) == 127)
      last = [job.tool " is not installed: `make setup` installs it"];
    elseif (isempty (last))
      last = "it does not say why";
    endif
    error ("toolchain:scene", "%s failed with status %d: %s\n", job.tool, WEXITSTATUS (status), last);
  endif
endfunction

%!error <gnuplot failed with status 3: second>
%! finish_tool (start_tool (tempdir (), "gnuplot", "sh -c 'echo first; echo second >&2; exit 3'"));
%!error <gnuplot failed with status 127: gnuplot is not installed: `make setup` installs it>
%! finish_tool (start_tool (tempdir (), "gnuplot", "no_such_command"));
%!error <gnuplot failed with status 2: it does not say why>
%! finish_tool (start_tool (tempdir (), "gnuplot", "sh -c 'exit 2'"));
