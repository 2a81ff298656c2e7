## -*- texinfo -*-
## @deftypefn {} {} finish_tools (@var{jobs})
## Wait for the end of all @var{jobs} (array) of @code{start_tool}; then the error of the first that failed, see
## @code{finish_tool}.
## @end deftypefn

function finish_tools (jobs)
  failed = [];
  for job = jobs
    try
      finish_tool (job);
    catch err
      if (isempty (failed))
        failed = err;
      endif
    end_try_catch
  endfor
  if (! isempty (failed))
    rethrow (failed);
  endif
endfunction

%!test # it waits for the second when the first has failed
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! jobs = [start_tool(tempdir (), "gnuplot", "sh -c 'echo no; exit 1'"), ...
%!         start_tool(tempdir (), "sleep", ["sh -c 'sleep 0.3; echo yes > " file "'"])];
%! fail ("finish_tools (jobs)", "gnuplot failed with status 1: no");
%! assert (fileread (file), "yes\n");
