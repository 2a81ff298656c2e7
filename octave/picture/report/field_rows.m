## -*- texinfo -*-
## @deftypefn {} {@var{cells} =} field_rows (@var{given}, @var{prefix})
## All fields of a struct @var{given}, a row each (n-by-2 texts): its name, with those of the structs it is in and the
## number in an array of structs, and its value (see @code{value_text}).
## @end deftypefn

function cells = field_rows (given, prefix = "")
  cells = cell (0, 2);
  for [value, name] = given
    if (isstruct (value) && ! isscalar (value))
      value = num2cell (value);
    endif
    if (iscell (value) && ! isempty (value) && all (cellfun (@isstruct, value(:))))
      for i = 1:numel (value)
        cells = [cells; field_rows(value{i}, sprintf("%s%s(%d).", prefix, name, i))];
      endfor
    elseif (isstruct (value))
      cells = [cells; field_rows(value, [prefix name "."])];
    else
      cells(end+1,:) = {[prefix name], value_text(value)};
    endif
  endfor
endfunction

%!test
%! cells = field_rows (struct ("a", 1, "b", struct ("c", "x"), "d", struct ("e", {2, 3})));
%! assert (cells, {"a", "1"; "b.c", "x"; "d(1).e", "2"; "d(2).e", "3"});
%! cells = field_rows (struct ("a", {{struct("b", 1), struct("c", 2)}}, "d", {{"x", "y"}}));
%! assert (cells, {"a(1).b", "1"; "a(2).c", "2"; "d", "x, y"});
