## -*- texinfo -*-
## @deftypefn {} {@var{html} =} fill_page (@var{name}, @var{page})
## The page of the file @var{name} beside this one, in which each @{@{field@}@} is what the struct @var{page} has in
## that field; what is filled in is not looked at again.  "style" is report.css where the @var{page} has none.
## @end deftypefn

function html = fill_page (name, page)
  here = fileparts (mfilename ("fullpath"));
  if (! isfield (page, "style"))
    page.style = fileread (fullfile (here, "report.css"));
  endif
  [names, between] = regexp (fileread (fullfile (here, name)), '\{\{(\w+)\}\}', "tokens", "split");
  values = cellfun (@(name) page.(name{1}), names, "UniformOutput", false);
  html = [[between; [values, {""}]]{:}];
endfunction

%!test # what is filled in may hold braces
%! names = regexp (fileread (fullfile (fileparts (which ("fill_page")), "report.html")), '(?<=\{\{)\w+', "match");
%! page = cell2struct (repmat ({"<{{title}}>"}, numel (names), 1), names, 1);
%! html = fill_page ("report.html", page);
%! assert (numel (strfind (html, "<{{title}}>")), numel (names));
%! html = fill_page ("report.html", rmfield (page, "style"));
%! assert (! isempty (strfind (html, "\n:root {\n")));
