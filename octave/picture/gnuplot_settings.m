## -*- texinfo -*-
## @deftypefn {} {@var{text} =} gnuplot_settings (@var{settings})
## The fields of the struct @var{settings}, texts or numbers, as variables of gnuplot; a field of two numbers, a range,
## gives the variables @var{name}_low and @var{name}_high.
## @end deftypefn

function text = gnuplot_settings (settings)
  text = "";
  for [value, name] = settings
    if (ischar (value))
      text = [text, sprintf("%s = %s\n", name, gnuplot_string (value))];
    elseif (isscalar (value))
      text = [text, sprintf("%s = %.12g\n", name, value)];
    else
      text = [text, sprintf("%s_low = %.12g\n%s_high = %.12g\n", name, value(1), name, value(2))];
    endif
  endfor
endfunction

%!test
%! text = gnuplot_settings (struct ("title", "a", "now", 0.5, "x", [1 2]));
%! assert (text, "title = 'a'\nnow = 0.5\nx_low = 1\nx_high = 2\n");
