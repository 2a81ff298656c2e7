## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} is_wide (@var{x})
## Whether positive numbers @var{x} span two decades or more, for which an axis has a logarithmic scale.
## @end deftypefn

function yes = is_wide (x)
  yes = min (x) > 0 && max (x) >= 100*min (x);
endfunction

%!assert ({is_wide([1; 100]), is_wide([1; 99]), is_wide([0; 1e3])}, {true, false, false})
