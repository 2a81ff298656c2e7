## -*- texinfo -*-
## @deftypefn {} {} write_report (@var{folder}, @var{drawing}, @var{given}, @var{summary}, @var{earlier})
## @file{report.html} in a @var{folder}, with @file{figure3.svg} and @file{history.svg} where they are there: one page
## that needs no other file and no network, made of the files beside this one. It animates @var{drawing} (see
## @code{draw_pictures}) and tells what the scene as it was @var{given} and the @var{summary} (structs of any fields;
## see @code{summarise}) say.  Studies that the folder @var{earlier} has (default: none) are shown (see
## @code{earlier_studies}).
## @end deftypefn

function write_report (folder, drawing, given, summary, earlier = "")
  picture = @(name, text) picture_or_word (fullfile (folder, [name ".svg"]), name, text);
  seconds = sprintf ("%.3g s", drawing.time(end) - drawing.time(1));
  panels = labels (drawing.panels);

  page.title = html_escape (drawing.title);
  page.warnings = warning_list (summary);
  scene_text = sprintf ("Animation of %s: %s in motion for %s; the deformation is drawn %g times.", drawing.title, ...
                        how_many (numel (drawing.bodies), "body", "bodies"), seconds, drawing.zoom);
  page.scene_text = html_escape (scene_text);
  page.strips_text = html_escape (["Over time: " labels(drawing.strips)]);
  page.figure3 = picture ("figure3", ["The bodies at even times over " seconds]);
  page.history = picture ("history", ["Over " seconds ": " panels]);
  page.history_text = html_escape (["Over time: " panels "."]);
  page.studies = "";
  if (! isempty (earlier))
    page.studies = earlier_studies (earlier);
  endif
  page.model = model_text (summary);
  page.command = html_escape (field_or (summary, "command", ""));
  page.summary = html_table ({}, field_rows (without (summary, ...
                                                 {"tried", "warnings", "seconds", "command", "model_reason"})));
  page.seconds = html_table ({}, [fieldnames(summary.seconds), struct2cell(summary.seconds)]);
  page.parameters = html_table ({"field", "value"}, field_rows (given));
  page.equations = report_equations (drawing.equations);
  page.data = report_data (drawing);
  page.script = fileread (fullfile (fileparts (mfilename ("fullpath")), "report.js"));
  write_text (fullfile (folder, "report.html"), fill_page ("report.html", page));
endfunction

function html = picture_or_word (file, name, text)
  if (exist (file, "file"))
    html = inline_svg (fileread (file), name, text);
  else
    html = ["<p>" name ".svg is missing: the warnings say why.</p>"];
  endif
endfunction

function text = labels (panels)
  text = "";
  if (! isempty (panels))
    text = strjoin ({panels.label}, ", ");
  endif
endfunction

function html = warning_list (summary)
  html = "";
  if (! isempty (summary.warnings))
    items = cellfun (@(text) ["<li>" html_escape(text) "</li>"], summary.warnings, "UniformOutput", false);
    html = ["<section class=\"warnings\" aria-label=\"Warnings\"><ul>" items{:} "</ul></section>"];
  endif
endfunction

function given = without (given, names)
  given = rmfield (given, intersect (names, fieldnames (given)));
endfunction

%!function html = report_in (folder, drawing, use, figures, tried)
%!  for name = figures
%!    write_text (fullfile (folder, [name{1} ".svg"(1:end*isempty (strfind (name{1}, ".")))]), ...
%!                "<svg xmlns='http://www.w3.org/2000/svg'><path id='a'/></svg>\n");
%!  endfor
%!  summary = struct ("model", "rigid", "model_reason", "a < b", "warnings", {{"x & <y>"}}, "tried", tried, ...
%!                    "seconds", struct ("frames", 2, "film", 1), "command", "make simulate MODES='1 2'");
%!  write_report (folder, drawing, struct ("moment", @(t) 3*(t < 1)), summary, folder);
%!  html = use (fullfile (folder, "report.html"));
%!endfunction
%!function html = report_of (drawing, use, figures = {"figure3", "history"}, tried = [])
%!  html = in_scratch (@(folder, scratch) report_in (folder, drawing, use, figures, tried));
%!endfunction

%!test # whole, escaped, its data parse, and it asks for nothing from elsewhere
%! drawing = sample_drawing (5);
%! drawing.title = "A <rod> & \"more\"";
%! html = report_of (drawing, @fileread);
%! check_tags (html);
%! assert (isempty (regexp (strrep (html, "http://www.w3.org/", ""), "https?://|src=|@import|url\\((?!#)")));
%! assert (isempty (strfind (html, "{{")));
%! data = regexp (html, '<script id="data" type="application/json">(.*?)</script>', "tokens"){1}{1};
%! assert (numel (jsondecode (data).time), 5);
%! for text = {"A &lt;rod&gt; &amp; &quot;more&quot;", "x &amp; &lt;y&gt;", "@(t) 3 * (t &lt; 1)", ...
%!             "MODES=&#39;1 2&#39;", "<mfrac>", "prefers-color-scheme: dark", "width=device-width", "aria-label"}
%!   assert (! isempty (strfind (html, text{1})), text{1});
%! endfor
%!test # with a study that was made there before
%! html = report_of (sample_drawing (2), @fileread, {"figure3", "modes"});
%! assert (isempty (strfind (html, "Natural modes")));  # without its table it is none
%! html = report_of (sample_drawing (2), @fileread, {"figure3", "modes", "modes.csv"});
%! check_tags (html);
%! assert (! isempty (regexp (html, 'Natural modes, asked for at')));
%!test # without its figures
%! html = report_of (sample_drawing (2), @fileread, {});
%! check_tags (html);
%! assert (! isempty (strfind (html, "<p>figure3.svg is missing: the warnings say why.</p>")));
%!test # of the models that were tried, the chosen one stands out, and none where none was
%! html = @(tried) report_of (sample_drawing (2), @fileread, {}, tried);
%! chosen = @(tried) regexp (html (tried), '<tr class="chosen">.*?</tr>', "match");
%! tried = struct ("name", {"1 mode", "rigid", "rigid"}, "error", {1, 2, 3}, "chosen", {false, true, false});
%! assert (chosen (tried), {'<tr class="chosen"><td>rigid</td><td class="number">2</td></tr>'});
%! assert (chosen (tried([1 3])), cell (1, 0));
%!test # several bodies
%! check_tags (report_of (sample_bodies (3), @fileread));
%!test # free bodies, nothing beside them
%! drawing = sample_bodies (2);
%! drawing.hinges = struct ("x", zeros (0, 2), "y", zeros (0, 2));
%! [drawing.strips, drawing.panels] = deal ([]);
%! check_tags (report_of (drawing, @fileread));

%!function dom = browsed (file)
%!  [~, dom] = system (["timeout 60 chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=3000" ...
%!                      " --dump-dom " shell_string(["file://" file]) " 2>/dev/null"]);
%!endfunction
%!testif ; system ("command -v chromium >/dev/null") == 0
%! ## Chromium runs it: all frames are known, the present one told
%! for drawing = {sample_drawing(5), sample_bodies(4)}
%!   dom = report_of (drawing{1}, @browsed);
%!   assert (! isempty (strfind (dom, sprintf ("data-drawn=\"%d\"", numel (drawing{1}.time)))));
%!   assert (! isempty (regexp (dom, '<p id="state">t = 0.00 s; [^<]+:')));
%! endfor
%!test # what is told to those who cannot see it
%! drawing = sample_drawing (5);
%! html = report_of (drawing, @fileread);
%! seconds = sprintf ("%.3g s", range (drawing.time));
%! labels = @(panels) strjoin ({panels.label}, ", ");
%! animation = "Animation of Rod with a half wave: 1 body in motion for %s; the deformation is drawn 300 times.";
%! for text = {sprintf(animation, seconds)
%!             ["Over time: " labels(drawing.strips)]; ["Over time: " labels(drawing.panels) "."]
%!             ["The bodies at even times over " seconds]; ["Over " seconds ": " labels(drawing.panels)]
%!             "<p>Derived by Maxima.</p>"; "a &lt; b"}.'
%!   assert (! isempty (strfind (html, text{1})), text{1});
%! endfor
