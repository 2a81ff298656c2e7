## -*- texinfo -*-
## @deftypefn {} {} run_tool (@var{folder}, @var{tool}, @var{command})
## Run the shell @var{command} in @var{folder}. It is an error when it fails: one line with the name of the @var{tool}
## and the last line that was printed.
## @end deftypefn

function run_tool (folder, tool, command)
  ## The locale decides how gnuplot reads the titles.
  [status, said] = system (sprintf ("export LC_ALL=C.UTF-8; { cd %s && %s; } 2>&1", shell_string (folder), command));
  if (status != 0)
    lines = strsplit (strtrim (said), "\n");
    error ("%s failed with status %d: %s", tool, status, strtrim (lines{end}));
  endif
endfunction

%!test # in the folder
%! run_tool (tempdir (), "test", ["test \"$(pwd -P)\" = \"$(cd " shell_string(tempdir ()) " && pwd -P)\""]);
%!error <gnuplot failed with status 3: second>
%! run_tool (tempdir (), "gnuplot", "sh -c 'echo first; echo second >&2; exit 3'");
%!error <gnuplot failed with status .*no folder>
%! run_tool (fullfile (tempdir (), "no folder"), "gnuplot", "true");
