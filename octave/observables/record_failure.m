## -*- texinfo -*-
## @deftypefn {} {} record_failure (@var{folder}, @var{name}, @var{scene}, @var{message})
## Leave in summary.json of the @var{folder} that a run failed, when and why: the field last_failure, which the next
## good run removes.  The other fields, like all other files, stay those of the last good run; without one there are
## only the scene, its title and its solver.
## @end deftypefn

function record_failure (folder, name, scene, message)
  file = fullfile (folder, "summary.json");
  summary = struct ("scene", name, "title", scene.title, "solver", scene.solver.name);
  if (exist (file, "file"))
    summary = jsondecode (fileread (file));
  endif
  summary.last_failure = struct ("time", strftime ("%Y-%m-%d %H:%M:%S", localtime (time ())), ...
                                 "message", strtrim (message));
  publish_run (folder, {"summary.json"}, @(aside) write_summary (summary, fullfile (aside, "summary.json")));
endfunction

%!test
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   scene = struct ("title", "A rod", "solver", struct ("name", "rk4"));
%!   record_failure (folder, "rod", scene, "rk4 stopped\n");
%!   record_failure (folder, "rod", scene, "it stopped again");
%!   summary = jsondecode (fileread (fullfile (folder, "summary.json")));
%!   assert (summary.last_failure.message, "it stopped again");
%!   assert (summary.title, "A rod");
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
