## -*- texinfo -*-
## @deftypefn {} {@var{html} =} model_text (@var{summary})
## What a report says of the model: its name, why it is that, and the table of what was tried (see @code{choose}),
## where the @var{summary} (see @code{summarise}) has these fields.
## @end deftypefn

function html = model_text (summary)
  reason = field_or (summary, "model_reason", "");
  if (! isempty (reason))
    reason = [": " reason];
  endif
  html = ["<p><strong>" html_escape(field_or (summary, "model", "")) "</strong>" html_escape(reason) ".</p>\n"];
  tried = field_or (summary, "tried", []);
  if (! isempty (tried))
    chosen = find ([tried.chosen]);
    tried = rmfield (tried, "chosen");
    names = fieldnames (tried).';
    cells = struct2cell (tried(:)).';
    texts = ! cellfun (@(value) isnumeric (value) && isscalar (value), cells);
    cells(texts) = cellfun (@value_text, cells(texts), "UniformOutput", false);
    html = [html, html_table(names, cells, chosen)];
  endif
endfunction

%!test # the chosen one of two is marked, and nothing is where nothing was tried
%! summary = struct ("model", "rigid", "model_reason", "a < b", ...
%!                   "tried", struct ("name", {"1 mode", "0 modes"}, "error_m", {0, 1}, "chosen", {false, true}));
%! html = model_text (summary);
%! assert (! isempty (strfind (html, "<strong>rigid</strong>: a &lt; b.")));
%! rows = regexp (html, '<tr.*?</tr>', "match");
%! assert (! isempty (strfind (rows{3}, "0 modes")));
%! assert (strcmp (strtok (rows{3}, ">"), strtok (rows{2}, ">")), false);
%! assert (model_text (struct ("model", "rigid")), "<p><strong>rigid</strong>.</p>\n");
