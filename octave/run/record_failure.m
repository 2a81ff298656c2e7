## -*- texinfo -*-
## @deftypefn {} {} record_failure (@var{output}, @var{name}, @var{scene}, @var{err})
## Leave in summary.json of the folder of @var{output} (see @code{take_options}) that a run's integration failed, when
## and why: the field last_failure, which the next good run removes.  @var{err} is the error, of which others than
## those of an integration leave nothing.  The other fields, like all other files, stay those of the last good run;
## without one there are only the scene, its title and its solver.
## @end deftypefn

function record_failure (output, name, scene, err)
  if (! strncmp (err.identifier, "toolchain:integration", 21) || isempty (output.folder))
    return;
  endif
  file = fullfile (output.folder, "summary.json");
  summary = struct ("scene", name, "title", scene.title, "solver", scene.solver.name);
  try
    last = jsondecode (fileread (file));
    last.scene;
    summary = last;
  catch  # there is none, or it is damaged
  end_try_catch
  summary.last_failure = struct ("time", strftime ("%Y-%m-%d %H:%M:%S", localtime (time ())), ...
                                 "message", strtrim (err.message));
  try
    publish_run (output.folder, {"summary.json"}, ...
                 @(aside) write_summary (summary, fullfile (aside, "summary.json")));
  catch not_written  # the run's own error is what is to be told
    say ("warning: the failure is not in summary.json: %s", strtrim (not_written.message));
  end_try_catch
endfunction

%!function fail_in (folder)
%!  scene = struct ("title", "A rod", "solver", struct ("name", "rk4"));
%!  failed = @(id, text) record_failure (struct ("folder", folder), "rod", scene, ...
%!                                       struct ("identifier", id, "message", text));
%!  failed ("toolchain:integration", "rk4 stopped\n");
%!  failed ("toolchain:integration:steep", "it stopped again");
%!  failed ("Octave:undefined-function", "no such thing");
%!  summary = jsondecode (fileread (fullfile (folder, "summary.json")));
%!  assert (summary.last_failure.message, "it stopped again");
%!  assert (summary.title, "A rod");
%!endfunction
%!test in_scratch (@(folder, scratch) fail_in (fullfile (folder, "new")));
%!test # a failure that cannot be recorded is no other failure
%! output.folder = "/proc/nowhere";
%! said = evalc ("record_failure (output, 'rod', struct ('title', 'A rod', 'solver', struct ('name', 'rk4')), \
%!                                struct ('identifier', 'toolchain:integration', 'message', 'rk4 stopped'))");
%! assert (! isempty (strfind (said, "warning: the failure is not in summary.json: the folder")));
