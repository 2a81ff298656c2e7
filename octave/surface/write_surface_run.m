## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} write_surface_run (@var{folder}, @var{system}, @var{scene}, @var{history}, @var{summary}, @var{start})
## All files of a run of a rod on a surface, whole or not at all, and what a person at the terminal wants to know of it; see
## @code{write_run}.
## @end deftypefn

function summary = write_surface_run (folder, system, scene, history, summary, start)
  names = {"history.csv", "summary.json", "frames", "animation.mp4", "animation.gif", ...
           "figure3.svg", "figure3.png", "figure3.pdf", "history.svg"};
  publish_run (folder, names, @write);
  report (folder, summary);

  function write (aside)
    write_surface_history (history, fullfile (aside, "history.csv"));
    drawing_start = tic ();
    summary.warnings = [summary.warnings, draw_surface_pictures(system, scene, history, aside)];
    summary.seconds.pictures = toc (drawing_start);
    summary.seconds.total = toc (start);
    write_summary (summary, fullfile (aside, "summary.json"));
  endfunction
endfunction

function report (folder, summary)
  say ("%s", summary.title);
  say ("a rod of %d + %d polynomials on the surface %s", summary.modes, summary.surface.name);
  say ("%s, tolerance %.2g m: %d steps, %d calls, energy balance within %.1g", summary.method, summary.tolerance_m, ...
          summary.steps, summary.rate_calls, summary.largest_energy_error);
  say ("seconds: %.1f integration, %.1f pictures, %.1f in all", summary.seconds.integration, summary.seconds.pictures, ...
          summary.seconds.total);
  cellfun (@(text) say ("warning: %s", text), summary.warnings);
  say ("%s/ has history.csv, summary.json, frames/, animation.mp4, animation.gif, figure3.svg, history.svg", folder);
endfunction

%!test # every file is there
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   scene = setfield (setfield (bowl (), "duration", 0.04), "model", "modes", [6 6]);
%!   evalc ("driver (scene, 'output', folder);");
%!   for name = {"history.csv", "summary.json", "frames/frame_0003.png", "figure3.svg", "figure3.png", "figure3.pdf", "history.svg"}
%!     assert (stat (fullfile (folder, name{1})).size > 300, name{1});
%!   endfor
%!   lines = strsplit (fileread (fullfile (folder, "history.csv")), "\n");
%!   assert (strncmp (lines{1}, "t [s],tip_x [m],tip_y [m],tip_z [m],alpha1_0,", 40));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
