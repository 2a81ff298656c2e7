## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} write_mechanism (@var{folder}, @var{scene}, @var{mechanism}, @var{history}, @var{summary}, @var{start})
## All files of a mechanism's run, whole or not at all, as @code{write_run} of one rod.
## @end deftypefn

function summary = write_mechanism (folder, scene, mechanism, history, summary, start)
  names = {"history.csv", "summary.json", "frames", "animation.mp4", "animation.gif", ...
           "figure3.svg", "figure3.png", "figure3.pdf", "history.svg", "report.html"};
  publish_run (folder, names, @write);

  function write (aside)
    write_mechanism_history (scene, mechanism, history, fullfile (aside, "history.csv"));
    drawing = mechanism_drawing (scene, mechanism, history);
    [warnings, seconds] = draw_pictures (drawing, aside);
    summary.warnings = [summary.warnings, warnings];
    for [value, part] = seconds
      summary.seconds.(part) = value;
    endfor
    report_start = tic ();
    write_report (aside, drawing, scene, summary);
    summary.seconds.report = toc (report_start);
    summary.seconds.total = toc (start);
    write_summary (summary, fullfile (aside, "summary.json"));
  endfunction
endfunction

%!error <cannot be made|can be written> write_mechanism ("/proc/nowhere", [], [], [], [], tic ())
