## -*- texinfo -*-
## @deftypefn {} {[@var{scale}, @var{name}] =} unit_prefix (@var{values}, @var{unit})
## The number @var{scale} that the @var{values} in @var{unit} are to be divided by, and the @var{name} of the unit with
## the prefix that stands for it, so that the largest value lies between 1 and 1000.
## @end deftypefn

function [scale, name] = unit_prefix (values, unit)
  prefixes = {"p", "n", "µ", "m", "", "k", "M", "G"};
  power = 0;
  if (any (values(:)))
    power = min (max (floor (log10 (max (abs (values(:)))) / 3), -4), 3);
  endif
  scale = 1000 ^ power;
  name = [prefixes{power + 5} unit];
endfunction

%!test
%! [scale, name] = unit_prefix ([0, -2.5e7], "Pa");
%! assert (scale, 1e6);
%! assert (name, "MPa");
%!test # nothing but zeros
%! [scale, name] = unit_prefix ([0 0], "m");
%! assert (scale, 1);
%! assert (name, "m");
%!test # no values
%! [~, name] = unit_prefix (zeros (0, 3), "J");
%! assert (name, "J");
%!test # each prefix begins at its own power, and the ends go on
%! for k = 1:8
%!   prefix = {"p", "n", "µ", "m", "", "k", "M", "G"}{k};
%!   for factor = [1.001 999]
%!     [scale, name] = unit_prefix ([0, -factor*1000^(k-5)], "m");
%!     assert (scale, 1000^(k - 5), -1e-12); assert (name, [prefix "m"]);
%!   endfor
%! endfor
%! assert (nthargout (2, @unit_prefix, 1e-14, "m"), "pm"); assert (nthargout (2, @unit_prefix, 5e14, "m"), "Gm");
