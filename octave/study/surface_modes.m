## -*- texinfo -*-
## @deftypefn {} {@var{table} =} surface_modes (@var{scenes}, @var{numbers}, @var{folder})
## Convergence in modes of the @var{scenes} (names) of rods on surfaces, over their first 0.3 s: the largest distance
## (m) of a centreline point in any frame between runs of n and of the last of the @var{numbers} of polynomials, for
## each n before. Leaves surface_modes.csv, .svg and .png in the @var{folder} (default output); @var{table} is a row a
## scene.
## @end deftypefn

function table = surface_modes (scenes = {"large_swing", "cylinder", "bowl", "saddle"}, numbers = [4 6 8 10 12 14], ...
                                folder = "output")
  require_folder (folder);
  for i = 1:numel (scenes)
    scene = feval (scenes{i});
    scene.duration = min (scene.duration, 0.3);
    for k = 1:numel (numbers)
      scene.model.modes = numbers([k k]);
      scene.solver.tolerance = 1e-5;
      histories{k} = driver (scene, "output", "").history;
    endfor
    found(i,:) = cellfun (@(history) apart (history, histories{end}), histories(1:end-1));
    printf ("%-12s%s\n", scenes{i}, sprintf ("%10.2g", found(i,:)));
  endfor
  publish_study (struct ("folder", folder, "pictures", true), {"surface_modes.csv"}, ...
                 {"surface_modes.svg", "surface_modes.png"}, ...
                 @(aside) write (found, scenes, numbers(1:end-1), aside), ...
                 @(scratch) draw (found, scenes, numbers(1:end-1), scratch));
  if (nargout > 0)
    table = found;
  endif
endfunction

function off = apart (a, b)
  off = max (sqrt ((a.x - b.x).^2 + (a.y - b.y).^2 + (a.z - b.z).^2)(:));
endfunction

function write (table, scenes, numbers, folder)
  header = ["scene," strjoin(arrayfun (@(n) sprintf ("%d modes [m]", n), numbers, "uniformoutput", false), ",")];
  lines = cellfun (@(name, k) [name sprintf(",%.17g", table(k,:))], scenes, num2cell (1:numel (scenes)), ...
                   "uniformoutput", false);
  write_text (fullfile (folder, "surface_modes.csv"), [strjoin([header, lines], "\n") "\n"]);
endfunction

function job = draw (table, scenes, numbers, scratch)
  write_text (fullfile (scratch, "settings.gp"), [gnuplot_settings(struct ("names", {scenes})), ...
                                                  gnuplot_block("modes", {[numbers; table].'})]);
  job = start_gnuplot (scratch, "surface_modes.gp");
endfunction

%!error <cannot be made|can be written> surface_modes ({"saddle"}, [3 4], "/proc/nowhere")
%!test # it falls with the number of modes
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   evalc ("table = surface_modes ({'saddle'}, [3 4 6], folder);");
%!   assert (table(2) < table(1));
%!   assert (stat (fullfile (folder, "surface_modes.png")).size > 10000);
%!   assert (isempty (strfind (evalc ("surface_modes ({'saddle'}, [3 4], folder)"), "ans =")));  # nothing is echoed
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
