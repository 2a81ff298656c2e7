## -*- texinfo -*-
## @deftypefn {} {@var{html} =} inline_svg (@var{svg}, @var{name}, @var{text})
## The text of an SVG file as it stands in HTML, with the alternative @var{text}; its identifiers begin with
## @var{name}, so that several pictures in one page do not mix theirs up.
## @end deftypefn

function html = inline_svg (svg, name, text)
  html = strtrim (svg(strfind (svg, "<svg")(1):end));
  html = regexprep (html, '<!--.*?-->|<desc>.*?</desc>|<title>.*?</title>|\sid="gnuplot_[^"]*"', "");
  html = regexprep (html, '(\sid=''|href=''#|url\(#)', ["$1" name "-"]);
  html = ["<svg role=\"img\" aria-label=\"" html_escape(text) "\"" html(5:end)];
endfunction

%!test
%! svg = "<?xml?>\n<svg >\n<title>G</title><g id=\"gnuplot_plot_1\"><use xlink:href='#a' id='b'/></g></svg>\n";
%! assert (inline_svg (svg, "one", "a & b"), ...
%!         "<svg role=\"img\" aria-label=\"a &amp; b\" >\n<g><use xlink:href='#one-a' id='one-b'/></g></svg>");
