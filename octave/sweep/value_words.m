## -*- texinfo -*-
## @deftypefn {} {@var{text} =} value_words (@var{value})
## A @var{value} of a table as a text from which @code{read_value} makes the same, with no more digits than that takes.
## @end deftypefn

function text = value_words (value)
  text = value;
  if (! ischar (value))
    text = strjoin (arrayfun (@shortest, value(:).', "uniformoutput", false), " ");
  endif
endfunction

function text = shortest (x)
  for digits = 15:17
    text = sprintf ("%.*g", digits, x);
    if (str2double (text) == x)
      break;
    endif
  endfor
endfunction

%!assert (value_words (0.3), "0.3")
%!assert (value_words ([0 4]), "0 4")
%!assert (value_words ("ode45"), "ode45")
%!test # every bit comes back
%! for x = [0.1 + 0.2, pi, -1/3, 1e-300, 2^53 + 2, realmin]
%!   assert (read_value (value_words (x), ""), x);
%! endfor
