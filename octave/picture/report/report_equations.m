## -*- texinfo -*-
## @deftypefn {} {@var{html} =} report_equations (@var{names})
## The equations of the report: the parts with the @var{names} (cellstr), @file{equations_NAME.tex} on the load path,
## of which a kind need not have any; a surface of one's own may have been derived without.
## @end deftypefn

function html = report_equations (names)
  html = "";
  for name = names
    file = file_in_loadpath (["equations_" name{1} ".tex"]);
    if (! isempty (file))
      html = [html, tex_to_html(fileread (file))];
    endif
  endfor
  if (isempty (html))
    html = "<p>None is derived.</p>";
  else
    html = ["<p>Derived by Maxima.</p>\n" html];
  endif
endfunction

%!assert (report_equations ({"nothing"}), "<p>None is derived.</p>")
%!test # what there is of them, in their order
%! html = report_equations ({"mechanism", "nothing", "straight"});
%! parts = cellfun (@(name) tex_to_html (fileread (file_in_loadpath (["equations_" name ".tex"]))), ...
%!                  {"mechanism", "straight"}, "uniformoutput", false);
%! assert (html, ["<p>Derived by Maxima.</p>\n" parts{:}]);
