## -*- texinfo -*-
## @deftypefn {} {} write_end (@var{kind}, @var{scene}, @var{run}, @var{folder})
## The state in which a @var{run} of a @var{kind} ended, as end.csv, from which another run can go on (see
## @code{end_before}): its kind, its model and the time (s); how many bodies it has, and its rung, as JSON; a number a
## line, coordinates, velocities and what else its system integrates; and the places of its points (m), one a line,
## with commas.
## @end deftypefn

function write_end (kind, scene, run, folder)
  head = sprintf ("%s: %s, at t = %g s\n", kind.name, kind.describe (scene, run).model, run.history.t(end));
  rung = run.rung;
  if (isfield (run.model, "basis"))  # eigenmodes are those of what acted in this run
    [rung.base, rung.basis] = deal (run.model.base, run.model.basis);
  endif
  model = jsonencode (struct ("bodies", numel (kind.models (scene)), "rung", {rung}));
  points = [run.x(:,end), run.y(:,end)];
  if (isfield (run, "z"))
    points(:,3) = run.z(:,end);
  endif
  row = [strjoin(repmat ({"%.17g"}, 1, columns (points)), ",") "\n"];
  write_text (fullfile (folder, "end.csv"), ...
              [head, model, "\n", sprintf("%.17g\n", run.end_state), sprintf(row, points.')]);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! kind = struct ("name", "rod", "describe", @(scene, run) struct ("model", "three modes"), "models", @(scene) 1);
%! run = struct ("end_state", [0.5; 1e-20], "history", struct ("t", [0 1.5]), "rung", 3, "model", 1);
%! [run.x, run.y] = deal ([0 1; 0 2], [0 3; 0 4]);
%! write_end (kind, struct (), run, folder);
%! state = ["0.5\n" sprintf("%.17g", 1e-20) "\n"];
%! head = "rod: three modes, at t = 1.5 s\n{\"bodies\":1,\"rung\":3}\n";
%! assert (fileread (fullfile (folder, "end.csv")), [head, state, "1,3\n2,4\n"]);
%! write_end (kind, struct (), setfield (run, "z", [0 5; 0 6]), folder);
%! assert (fileread (fullfile (folder, "end.csv")), [head, state, "1,3,5\n2,4,6\n"]);
%! run.rung = struct ("bending", 1);
%! run.model = struct ("base", struct ("transversal", [1 2]), "basis", [0.5; 0.25]);
%! write_end (kind, struct (), run, folder);
%! said = jsondecode (strsplit (fileread (fullfile (folder, "end.csv")), "\n"){2}).rung;
%! assert ({said.bending, said.base.transversal, said.basis}, {1, [1; 2], [0.5; 0.25]});
