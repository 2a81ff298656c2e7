## -*- texinfo -*-
## @deftypefn {} {} run_tool (@var{folder}, @var{tool}, @var{command})
## Run the shell @var{command} in @var{folder}; see @code{finish_tool} for its errors.
## @end deftypefn

function run_tool (folder, tool, command)
  finish_tool (start_tool (folder, tool, command));
endfunction

%!test # in the folder
%! run_tool (tempdir (), "test", ["test \"$(pwd -P)\" = \"$(cd " shell_string(tempdir ()) " && pwd -P)\""]);
%!error <gnuplot failed with status .*no folder>
%! run_tool (fullfile (tempdir (), "no folder"), "gnuplot", "true");
