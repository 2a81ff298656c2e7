## -*- texinfo -*-
## @deftypefn {} {@var{columns} =} read_columns (@var{names}, @var{where})
## The names of a table's columns (cellstr), without blanks around them: dotted names of a scene's fields, as
## "rod.length", "bodies(2).rod.length" and "joints(1).stiffness", or "argument.1", the first argument of the scene's
## function.  Others, and one that stands twice, are an error that says @var{where}.
## @end deftypefn

function columns = read_columns (names, where)
  columns = strtrim (names);
  part = '[A-Za-z]\w*(\([1-9]\d*\))?';
  for k = 1:numel (columns)
    if (isempty (regexp (columns{k}, ['^(argument\.[1-9]\d*|' part '(\.' part ')*)$'], "once")))
      scene_error ("%s: \"%s\" is no name of a field, as rod.length or bodies(2).rod.length, and no argument.1", ...
                   where, columns{k});
    elseif (any (strcmp (columns{k}, columns(1:k-1))))
      scene_error ("%s: %s stands there twice", where, columns{k});
    endif
  endfor
endfunction

%!assert (read_columns ({" rod.length", "argument.2 ", "joints(1).stiffness", "zoom"}, ""), ...
%!        {"rod.length", "argument.2", "joints(1).stiffness", "zoom"})
%!error <VARY: a stands there twice> read_columns ({"a", "b", "a"}, "VARY")
%!test
%! for bad = {"", "rod length", "rod.length=1", "\"a\"", "1", "argument.0", "bodies(0).x", "a..b", "a(2)(3)", "a()"}
%!   fail ("read_columns (bad, 'points.csv')", "points.csv: \".*\" is no name of a field");
%! endfor
