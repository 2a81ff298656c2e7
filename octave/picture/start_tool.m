## -*- texinfo -*-
## @deftypefn {} {@var{job} =} start_tool (@var{folder}, @var{tool}, @var{command})
## Start the shell @var{command} in @var{folder}, and go on; @code{finish_tool} waits for its end. The name of the
## @var{tool} is for messages.
## @end deftypefn

function job = start_tool (folder, tool, command)
  job.tool = tool;
  job.log = tempname ();
  ## The locale decides how gnuplot reads the titles.  A limit of file sizes fails a tool's writing, as a full disk
  ## does, and does not kill it.
  job.pid = system (sprintf ("trap '' XFSZ; export LC_ALL=C.UTF-8; { CDPATH= cd -- %s && %s; } >%s 2>&1 </dev/null", ...
                             shell_string (folder), command, shell_string (job.log)), false, "async");
endfunction

%!test # it does not wait
%! job = start_tool (tempdir (), "sleep", "sleep 1");
%! assert (waitpid (job.pid, WNOHANG ()), 0);
%! finish_tool (job);
%!test # in the folder
%! finish_tool (start_tool (tempdir (), "test", ["test \"$(pwd -P)\" = \"$(cd " shell_string(tempdir ()) " && pwd -P)\""]));
%!error <gnuplot failed with status .*no folder>
%! finish_tool (start_tool (fullfile (tempdir (), "no folder"), "gnuplot", "true"));
