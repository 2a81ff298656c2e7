## -*- texinfo -*-
## @deftypefn {} {@var{x} =} rounded_digits (@var{x})
## The numbers @var{x} to twelve digits, as one would type them: 0.3 for 0.1 + 0.2.
## @end deftypefn

function x = rounded_digits (x)
  x = reshape (str2double (arrayfun (@(x) sprintf ("%.12g", x), x, "uniformoutput", false)), size (x));
endfunction

%!assert (rounded_digits ([0.1 + 0.2, 1/3; 1, 2]), [0.3, 0.333333333333; 1, 2])
