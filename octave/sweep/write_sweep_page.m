## -*- texinfo -*-
## @deftypefn {} {} write_sweep_page (@var{plan}, @var{found}, @var{state}, @var{pictures}, @var{folder})
## sweep.html in the @var{folder}: what a sweep of a @var{plan} (see @code{plan_sweep}) has @var{found} by now (see
## @code{gather_rows}), the command, those @var{pictures} (cellstr) that are there, and the first thousand points, with
## links to what of their runs was kept; @var{state} is as for @code{write_sweep}.
## @end deftypefn

function write_sweep_page (plan, found, state, pictures, folder)
  count = numel (plan.keys);
  shown = min (count, 1000);
  page.title = html_escape (sprintf ("%d points of %s", count, plan.name));
  page.state = html_escape (state_text (found, state));
  page.command = html_escape (plan.call);
  page.figures = figures_of (pictures, plan);
  page.sensitivity = sensitivity_of (found.sensitivity);
  page.points = points_table (plan, found, 1:shown);
  page.more = ["<a href=\"summary.csv\">summary.csv</a> has all that are done," ...
               " <a href=\"sweep.json\">sweep.json</a> what failed."];
  if (shown < count)
    page.more = sprintf ("These are the first %d of %d points: %s", shown, count, page.more);
  endif
  page.about = html_table ({}, field_rows (plan.about));
  write_text (fullfile (folder, "sweep.html"), fill_page ("sweep.html", page));
endfunction

function text = state_text (found, state)
  failed = sum (have_failed (found));
  done = sum (found.done);
  text = sprintf ("%d done, %d failed, %d missing; by %s, %g at a time; %.3g s by now.", done, failed, ...
                  numel (found.done) - done - failed, state.engine, state.jobs, state.seconds);
  if (state.running)
    text = [text " It is running, or was killed."];
  endif
endfunction

function html = figures_of (pictures, plan)
  html = "";
  for name = pictures
    text = html_escape (["over " strjoin(plan.columns, ", ") ": " plan.about.observe]);
    html = [html, sprintf("<figure><img src=\"%s\" alt=\"%s\"></figure>\n", name{1}, text)];
  endfor
endfunction

function html = sensitivity_of (cells)
  html = "";
  if (! isempty (cells))
    heads = {"observation", "field", "points", "standardised coefficient", "R^2", "first order index", "its error"};
    note = ["<p>By how many of its standard deviations an observation goes up where a field does by one of its" ...
            " own, in the linear model that explains R^2 of its variance; and the share of the variance that the" ...
            " field has alone. <a href=\"sensitivity.csv\">sensitivity.csv</a> has the numbers.</p>\n"];
    html = ["<section aria-labelledby=\"sensitivity\">\n<h2 id=\"sensitivity\">Sensitivity</h2>\n", note, ...
            html_table(heads, cells), "</section>\n"];
  endif
endfunction

function html = points_table (plan, found, index)
  values = cellfun (@value_words, plan.values(index,:), "uniformoutput", false);
  links = arrayfun (@(k) link_of (plan, found, k), index(:), "uniformoutput", false);
  observed = cellfun (@rounded, found.observed(index,:), "uniformoutput", false);
  heads = [{"point"}, plan.columns, strcat({plan.items.text}, plan.units), {"failed"}];
  failed = find (have_failed (found)(index));
  html = html_table (heads, [links, values, observed, found.message(index).'], failed);
endfunction

## the report or the folder of a run that was kept
function cell = link_of (plan, found, k)
  cell = sprintf ("%d", k);
  kept = fullfile ("points", plan.keys{k});
  if (found.done(k) && (plan.drawn || plan.settings.keep))
    cell = struct ("text", cell, "address", [kept "/"]);
    if (exist (fullfile (plan.folder, kept, "report.html"), "file"))
      cell.address = [kept "/report.html"];
    endif
  endif
endfunction

function text = rounded (text)
  number = str2double (text);
  if (isfinite (number))
    text = sprintf ("%.6g", number);
  endif
endfunction

%!function html = page (folder, count, pictures, sensitivity = cell (0, 7))
%!  plan = struct ("folder", folder, "name", "swing", "call", "make sweep VARY='a<b'", "columns", {{"a", "b"}}, ...
%!                 "values", {repmat({0.1 "x"; [0 4] "y"; 3 "z"}, count/3, 1)}, "drawn", false, ...
%!                 "settings", struct ("keep", true), "about", struct ("observe", "max u, model"), ...
%!                 "units", {{" [m]", ""}});
%!  plan.keys = arrayfun (@(k) sprintf ("k%d", k), 1:count, "uniformoutput", false);
%!  plan.items = struct ("text", {"max u", "model"});
%!  mkdir (fullfile (folder, "points", "k2")); write_text (fullfile (folder, "points", "k2", "report.html"), "x");
%!  found = struct ("observed", {repmat({"0.5123456789", "rigid"; "1", "6 & more"; "", ""}, count/3, 1)}, ...
%!                  "done", repmat ([true true false], 1, count/3), ...
%!                  "message", {repmat({"", "", "it <failed>"}, 1, count/3)}, ...
%!                  "sensitivity", {sensitivity});
%!  state = struct ("running", false, "engine", "make", "jobs", 2, "seconds", 7);
%!  write_sweep_page (plan, found, state, pictures, folder);
%!  html = fileread (fullfile (folder, "sweep.html"));
%!endfunction
%!test # the points with what they have and where it is, the command, the pictures
%! html = in_scratch (@(folder, scratch) page (folder, 3, {"sweep.svg"}));
%! check_tags (html);
%! rows = regexp (html, '<tr[ >].*?</tr>', "match");
%! assert (rows{2}, ["<tr><td><a href=\"points/k1/\">1</a></td><td>0.1</td><td>x</td><td>0.512346</td>" ...
%!                   "<td>rigid</td><td></td></tr>"]);
%! assert (! isempty (strfind (rows{3}, "<a href=\"points/k2/report.html\">2</a></td><td>0 4</td>")));
%! assert (rows{4}, ["<tr class=\"chosen\"><td>3</td><td>3</td><td>z</td><td></td><td></td>" ...
%!                   "<td>it &lt;failed&gt;</td></tr>"]);
%! for text = {"<h1>3 points of swing</h1>", "2 done, 1 failed, 0 missing; by make, 2 at a time; 7 s", "max u [m]", ...
%!             "VARY=&#39;a&lt;b&#39;", "<img src=\"sweep.svg\" alt=\"over a, b: max u, model\">", "summary.csv"}
%!   assert (! isempty (strfind (html, text{1})), text{1});
%! endfor
%!test # of random points how much each matters
%! cells = {"max u", "rod.length", 50, 0.25, 0.5, 0.125, 0.01};
%! html = in_scratch (@(folder, scratch) page (folder, 3, {}, cells));
%! assert (! isempty (strfind (html, "<td>rod.length</td><td class=\"number\">50</td>")));
%!test # a long one
%! html = in_scratch (@(folder, scratch) page (folder, 1200, {}));
%! assert (numel (strfind (html, "<tr")), 1002);
%! assert (! isempty (strfind (html, "These are the first 1000 of 1200 points")));
%! assert (isempty (strfind (html, "<img")));
