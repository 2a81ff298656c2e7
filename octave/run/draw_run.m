## -*- texinfo -*-
## @deftypefn {} {@var{summary} =} draw_run (@var{folder}, @var{given}, @var{summary}, @var{start}, @var{draw}, @
##   @var{earlier})
## The pictures of the drawing that @var{draw} () returns (see @code{draw_pictures}), and the report, in the existing
## @var{folder}; the report shows the scene as it was @var{given}, and studies that the folder @var{earlier} has.  The
## @var{summary} comes back with the seconds of each part, those since @var{start} (a tic), and with warnings of what
## could not be made.
## @end deftypefn

function summary = draw_run (folder, given, summary, start, draw, earlier = "")
  drawing_start = tic ();
  show_progress (sprintf ("drawing %d frames ", summary.frames));
  drawing = draw ();
  if (isfield (drawing, "notes"))
    summary.notes = drawing.notes;
  endif
  summary.seconds.drawing = toc (drawing_start);
  [missing, warnings, seconds] = draw_pictures (drawing, folder);
  before = [summary.warnings, warnings];
  summary.warnings = [before, missing_warnings(missing)];
  for [value, part] = seconds
    summary.seconds.(part) = value;
  endfor
  summary.seconds.pictures = toc (drawing_start);
  summary.seconds.total = toc (start);
  report_start = tic ();
  try
    write_report (folder, drawing, given, summary, earlier);
  catch err
    [~, ~] = unlink (fullfile (folder, "report.html"));
    missing(end+1,:) = {"report.html", reason_of(err)};
    summary.warnings = [before, missing_warnings(missing)];
  end_try_catch
  summary.seconds.report = toc (report_start);
endfunction

%!function draw_without_report (folder)
%!  mkdir (fullfile (folder, "report.html"));
%!  summary = struct ("frames", 2, "model", "rigid", "warnings", {{}}, "seconds", struct ());
%!  summary = draw_run (folder, struct (), summary, tic (), @() sample_drawing (2));
%!  assert (numel (summary.warnings), 1);
%!  assert (! isempty (regexp (summary.warnings{1}, "^report.html is missing: .* cannot be written: ")));
%!  assert (stat (fullfile (folder, "history.svg")).size > 1000);
%!endfunction
%!test # a report that cannot be written is a warning, and the pictures stay
%! in_scratch (@(folder, scratch) draw_without_report (folder));
