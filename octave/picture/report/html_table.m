## -*- texinfo -*-
## @deftypefn {} {@var{html} =} html_table (@var{head}, @var{cells}, @var{chosen})
## A table of HTML: the names of its columns @var{head} (1-by-n cellstr, or @{@} for none), and @var{cells} (m-by-n
## texts or numbers, as they are: they are escaped here; a struct of text and address is a link). The rows @var{chosen}
## ([] for none) stand out.
## @end deftypefn

function html = html_table (head, cells, chosen = [])
  html = "<div class=\"wide\"><table>\n";
  if (! isempty (head))
    titles = cellfun (@(name) ["<th scope=\"col\">" html_escape(name) "</th>"], head, "UniformOutput", false);
    html = [html, "<tr>", titles{:}, "</tr>\n"];
  endif
  lines = cell (1, rows (cells));
  for row = 1:rows (cells)
    parts = cellfun (@cell_of, cells(row,:), "UniformOutput", false);
    tag = "<tr>";
    if (any (row == chosen))
      tag = "<tr class=\"chosen\">";
    endif
    lines{row} = [tag, parts{:}, "</tr>\n"];
  endfor
  html = [html, lines{:}, "</table></div>\n"];
endfunction

function html = cell_of (value)
  if (isnumeric (value) && isscalar (value))
    digits = sprintf ("%.4g", value);
    if (value == fix (value))
      digits = sprintf ("%d", value);
    endif
    html = ["<td class=\"number\">" digits "</td>"];
  elseif (isstruct (value))
    html = ["<td><a href=\"" html_escape(value.address) "\">" html_escape(value.text) "</a></td>"];
  else
    html = ["<td>" html_escape(value) "</td>"];
  endif
endfunction

%!test
%! html = html_table ({"a<b"}, {"x&y"; 0.25; 50844}, 2);
%! assert (! isempty (strfind (html, "<th scope=\"col\">a&lt;b</th>")));
%! assert (! isempty (strfind (html, ">50844<")));
%! assert (! isempty (strfind (html, "<tr class=\"chosen\"><td class=\"number\">0.25</td></tr>")));
%!test
%! html = html_table ({}, {"x", struct("text", "a & b", "address", "p/\"q\".html")});
%! assert (! isempty (strfind (html, "<tr><td>x</td><td><a href=\"p/&quot;q&quot;.html\">a &amp; b</a></td></tr>")));
%! assert (numel (strfind (html_table ({}, {1; 2; 3}, [1 3]), "chosen")), 2);
