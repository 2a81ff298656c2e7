## -*- texinfo -*-
## @deftypefn {} {@var{html} =} earlier_studies (@var{folder})
## The section of report.html on the studies of the scene that the @var{folder} of its output has, from @code{make
## statics}, @code{modes}, @code{campbell} and so on: the picture of each with the time when it was made and its table.
## Empty where there is none.
## @end deftypefn

function html = earlier_studies (folder)
  studies = {
    "shape",     "shape.csv",     "Where it comes to rest under its loads"
    "along",     "along.csv",     "Forces, moments and stress along the rods, at rest"
    "path",      "path.csv",      "Equilibria as its loads grow"
    "modes",     "modes.csv",     "Natural modes"
    "campbell",  "campbell.csv",  "Frequencies against the speed of rotation"
    "response",  "response.csv",  "Response to harmonic loads"
    "models",    "models.csv",    "Models, their error and their seconds"
    "chart",     "chart.csv",     "Integrators, error against work"
    "stability", "stability.csv", "Where integrators turn unstable"
  };
  figures = "";
  for study = studies.'
    [name, table, text] = study{:};
    picture = fullfile (folder, [name ".svg"]);
    if (exist (picture, "file") && exist (fullfile (folder, table), "file"))
      made = strftime ("%Y-%m-%d %H:%M", localtime (stat (picture).mtime));
      caption = sprintf ("%s, asked for at %s: <a href=\"%s\">%s</a>.", text, made, table, table);
      figures = [figures, "<figure>" inline_svg(fileread (picture), name, text) ...
                 "\n<figcaption>" caption "</figcaption></figure>\n"];
    endif
  endfor
  html = "";
  if (! isempty (figures))
    html = ["<section aria-labelledby=\"studies\">\n<h2 id=\"studies\">Studies</h2>\n" ...
            "<p>Of the scene as it was when they were asked for.</p>\n" figures "</section>"];
  endif
endfunction

%!function html = with_files (folder, names)
%!  for name = names
%!    write_text (fullfile (folder, name{1}), "<svg><path id='a'/></svg>");
%!  endfor
%!  html = earlier_studies (folder);
%!endfunction
%!test # those whose picture and table are there, and none
%! html = in_scratch (@(folder, scratch) with_files (folder, {"modes.svg", "modes.csv", "path.csv", "chart.svg"}));
%! assert (numel (strfind (html, "<figure>")), 1);
%! assert (! isempty (regexp (html, '<path id=''modes-a''/>.*Natural modes, asked for at 2\d{3}-\d\d-\d\d \d\d:\d\d')));
%! assert (! isempty (strfind (html, "<a href=\"modes.csv\">modes.csv</a>")));
%! assert (in_scratch (@(folder, scratch) with_files (folder, {})), "");
