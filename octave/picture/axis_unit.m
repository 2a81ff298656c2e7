## -*- texinfo -*-
## @deftypefn {} {[@var{scale}, @var{name}] =} axis_unit (@var{range}, @var{unit})
## As @code{unit_prefix}, but 1 and the @var{unit} itself where the @var{range} is neither shorter than a hundredth of
## it nor longer than ten thousand.
## @end deftypefn

function [scale, name] = axis_unit (range, unit)
  scale = 1;
  name = unit;
  if (diff (range) < 0.01 || diff (range) > 1e4)
    [scale, name] = unit_prefix (diff (range), unit);
  endif
endfunction

%!test
%! [scale, name] = axis_unit ([-2 3], "m"); assert ({scale, name}, {1, "m"});
%! [scale, name] = axis_unit ([-2e-5 3e-5], "m"); assert (scale, 1e-6, 1e-20); assert (name, "µm");
%! [scale, name] = axis_unit ([0 2e4], "s"); assert ({scale, name}, {1000, "ks"});
