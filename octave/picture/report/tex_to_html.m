## -*- texinfo -*-
## @deftypefn {} {@var{html} =} tex_to_html (@var{tex})
## What @file{maxima/print.mac} wrote, a heading, a note or a formula a line, as HTML. A formula may be broken where a
## term of its sides begins.
## @end deftypefn

function html = tex_to_html (tex)
  html = "";
  for line = strsplit (strtrim (tex), "\n")
    words = regexp (line{1}, '^\\(section\*\{|par )(.*?)\}?$', "tokens", "once");
    if (isempty (words))
      terms = cellfun (@tex_to_mathml, terms_of (line{1}), "UniformOutput", false);
      html = [html, "<div class=\"formula\">", strjoin(terms, "\n"), "</div>\n"];
    else
      tag = "h3";
      if (strcmp (words{1}, "par "))
        tag = "p";
      endif
      html = [html, "<", tag, ">", with_symbols(words{2}), "</", tag, ">\n"];
    endif
  endfor
endfunction

## words, with formulas between dollar signs
function html = with_symbols (text)
  parts = strsplit (text, "$");
  for i = 1:numel (parts)
    if (mod (i, 2))
      parts{i} = html_escape (parts{i});
    else
      parts{i} = tex_to_mathml (parts{i});
    endif
  endfor
  html = [parts{:}];
endfunction

## A sign or = that is in no group begins a term, unless it is the first of its side.
function terms = terms_of (tex)
  deeper = zeros (1, numel (tex));
  deeper([strfind(tex, "{"), strfind(tex, "\\left")]) = 1;
  deeper([strfind(tex, "}"), strfind(tex, "\\right")]) = -1;
  [first, last] = regexp (tex, '(?<=[^\s=])\s*[-+=]');
  outside = cumsum (deeper)(first) == 0;
  terms = mat2cell (tex, 1, diff ([1, first(outside), numel(tex) + 1]));
endfunction

%!function html = math (inner)
%!  html = ["<math displaystyle=\"true\"><mrow>" inner "</mrow></math>"];
%!endfunction
%!test
%! html = tex_to_html ("\\section*{A & B, (5)}\n\\par By $x$, up\na = 1\n");
%! expected = ["<h3>A &amp; B, (5)</h3>\n<p>By " math("<mi>x</mi>") ", up</p>\n<div class=\"formula\">" ...
%!             math("<mi>a</mi>") "\n" math("<mo stretchy=\"false\" form=\"infix\">=</mo><mn>1</mn>") "</div>\n"];
%! assert (html, expected);
%!test # every part that a run can name
%! for name = {"hinged", "straight", "curved", "mechanism", "surface", "surface_torus"}
%!   html = tex_to_html (fileread (file_in_loadpath (["equations_" name{1} ".tex"])));
%!   assert (! isempty (strfind (html, "<h3>")) && ! isempty (strfind (html, "<math")));
%! endfor
