## -*- texinfo -*-
## @deftypefn {} {@var{cells} =} field_rows (@var{given}, @var{prefix})
## All fields of a struct @var{given}, a row each (n-by-2 texts): its name, with those of the structs it is in and the
## number in a struct array, and its value (see @code{value_text}).
## @end deftypefn

function cells = field_rows (given, prefix = "")
  cells = cell (0, 2);
  for [value, name] = given
    if (isstruct (value) && isscalar (value))
      cells = [cells; field_rows(value, [prefix name "."])];
    elseif (isstruct (value))
      for i = 1:numel (value)
        cells = [cells; field_rows(value(i), sprintf("%s%s(%d).", prefix, name, i))];
      endfor
    else
      cells(end+1,:) = {[prefix name], value_text(value)};
    endif
  endfor
endfunction

%!test
%! cells = field_rows (struct ("a", 1, "b", struct ("c", "x"), "d", struct ("e", {2, 3})));
%! assert (cells, {"a", "1"; "b.c", "x"; "d(1).e", "2"; "d(2).e", "3"});
