## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} write_run (@var{folder}, @var{scene}, @var{summary}, @var{start}, @
##   @var{write_table}, @var{draw})
## All files of a run, whole or not at all, and what a person at the terminal wants to know of it: history.csv by
## @var{write_table} (file), and the pictures of the drawing that @var{draw} () returns (see @code{draw_pictures}).
## The summary comes back with the seconds of each part, those since @var{start} (a tic), and the drawing's warnings.
## @end deftypefn

function summary = write_run (folder, scene, summary, start, write_table, draw)
  names = {"history.csv", "summary.json", "frames", "animation.mp4", "animation.gif", ...
           "figure3.svg", "figure3.png", "figure3.pdf", "history.svg", "report.html"};
  publish_run (folder, names, @write);
  made = names(cellfun (@(name) exist (fullfile (folder, name)) > 0, names));
  cellfun (@(line) say ("%s", line), closing_lines (folder, summary, made));

  function write (aside)
    write_table (fullfile (aside, "history.csv"));
    drawing_start = tic ();
    show_progress (sprintf ("drawing %d frames ", summary.frames));
    drawing = draw ();
    summary.seconds.drawing = toc (drawing_start);
    [warnings, seconds] = draw_pictures (drawing, aside);
    summary.warnings = [summary.warnings, warnings];
    for [value, part] = seconds
      summary.seconds.(part) = value;
    endfor
    summary.seconds.pictures = toc (drawing_start);
    summary.seconds.total = toc (start);
    report_start = tic ();
    write_report (aside, drawing, scene, summary);
    summary.seconds.report = toc (report_start);
    summary.seconds.total = toc (start);
    write_summary (summary, fullfile (aside, "summary.json"));
  endfunction
endfunction

%!test # every file of a run is there
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   evalc ("result = driver ('paper', 'modes', [0 0], 'output', folder);");
%!   assert (numel (glob (fullfile (folder, "frames", "*.png"))), 91);
%!   assert (rows (csvread (fullfile (folder, "history.csv"), 1, 0)), 91);
%!   assert (jsondecode (fileread (fullfile (folder, "summary.json"))).frames, 91);
%!   for name = {"animation.mp4", "animation.gif", "figure3.svg", "history.svg", "report.html"}
%!     assert (stat (fullfile (folder, name{1})).size > 10000);
%!   endfor
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
