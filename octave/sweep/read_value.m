## -*- texinfo -*-
## @deftypefn {} {@var{value} =} read_value (@var{text}, @var{where})
## The value of a cell of a table: a number, several with a blank between (a row), or a word, such as the name of a
## solver.  All else, a formula, a path, a quote, nothing at all, is an error that says @var{where}.
## @end deftypefn

function value = read_value (text, where)
  text = strtrim (text);
  number = '[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?';
  if (isempty (text))
    scene_error ("%s is blank: it takes a number, several with a blank between, or a word", where);
  elseif (matches (text, [number '( ' number ')*']))
    value = sscanf (text, "%f").';
    if (! all (isfinite (value)))
      scene_error ("%s is %s: that is more than a number holds", where, text);
    endif
  elseif (matches (text, '[A-Za-z]\w*'))
    value = text;
  else
    scene_error ("%s is \"%s\": it takes a number, several with a blank between, or a word", where, text);
  endif
endfunction

function yes = matches (text, pattern)
  yes = ! isempty (regexp (text, ['^' pattern '$'], "once"));
endfunction

%!assert (read_value (" -1.5e-3 ", ""), -1.5e-3)
%!assert (read_value (".5", ""), 0.5)
%!assert (read_value ("0 4", ""), [0 4])
%!assert (read_value ("ode45", ""), "ode45")
%!error <row 2, rod.length is blank: it takes a number> read_value (" ", "row 2, rod.length")
%!test # nothing that would have to be computed, opened or unquoted
%! for bad = {"=1+2", "2*pi", "1e", "1..2", "/etc/passwd", "../x", "\"1\"", "'a'", "1;2", "$HOME", "f(1)", "1  2", ...
%!            "1\t2", "0x1f", "1,2", "a b", "1 a"}
%!   fail ("read_value (bad{1}, 'rod.length')", "rod.length is \".*\": it takes a number, several");
%! endfor
%!error <a is 1e999: that is more than a number holds> read_value ("1e999", "a")
