## -*- texinfo -*-
## @deftypefn {} {[@var{numbers}, @var{pictures}] =} run_files ()
## The names that a run can leave in its folder, as @code{publish_run} takes them (cellstr).
## @end deftypefn

function [numbers, pictures] = run_files ()
  numbers = {"history.csv", "summary.json", "end.csv", "dense.csv"};
  pictures = {"frames/frame_*.png", "animation.mp4", "animation.gif", "figure3.svg", "figure3.png", "figure3.pdf", ...
              "history.svg", "report.html"};
endfunction

%!test # frames are those of draw_pictures
%! [numbers, pictures] = run_files ();
%! assert (regexprep (frame_names (7, 9), '\d+', "*"), pictures(1)); assert (numbers{1}, "history.csv");
