## -*- texinfo -*-
## @deftypefn {} {@var{range} =} padded_range (@var{values})
## A @var{range} (1-by-2) for an axis that shows all @var{values}, with a margin of 6 %; never an empty one.
## @end deftypefn

function range = padded_range (values)
  low = min (values(:));
  high = max (values(:));
  margin = 0.06 * (high - low);
  if (high == 0 && low == 0)
    margin = 1;
  elseif (margin <= 1e-12 * max (abs (values(:))))
    margin = 0.06 * abs (high);
  endif
  range = [low - margin, high + margin];
endfunction

%!assert (padded_range ([0 1]), [-0.06 1.06], 1e-15)
%!assert (padded_range ([0 0]), [-1 1])
%!assert (padded_range ([1e-3 1e-3]), [0.94e-3 1.06e-3], 1e-12)
