## -*- texinfo -*-
## @deftypefn {} {} write_end (@var{kind}, @var{scene}, @var{run}, @var{folder})
## The state in which a @var{run} of a @var{kind} ended, as end.csv: its kind, its model and the time (s), then a
## number a line, coordinates, velocities and what else its system integrates, from which another run can go on (see
## @code{started_system}).
## @end deftypefn

function write_end (kind, scene, run, folder)
  head = sprintf ("%s: %s, at t = %g s\n", kind.name, kind.describe (scene, run).model, run.history.t(end));
  write_text (fullfile (folder, "end.csv"), [head, sprintf("%.17g\n", run.end_state)]);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! kind = struct ("name", "rod", "describe", @(scene, run) struct ("model", "three modes"));
%! write_end (kind, struct (), struct ("end_state", [0.5; 1e-20], "history", struct ("t", [0 1.5])), folder);
%! assert (fileread (fullfile (folder, "end.csv")), ...
%!         ["rod: three modes, at t = 1.5 s\n0.5\n" sprintf("%.17g", 1e-20) "\n"]);
