## -*- texinfo -*-
## It is an error where the @var{values}, drawn from @var{low} to @var{high} (positive) with logarithms that are
## uniform, are not all between these, or stay far from an end.

function assert_spans (values, low, high)
  position = log (values(:)/low)/log (high/low);
  assert (position >= -1e-9 & position <= 1 + 1e-9);
  assert ([min(position), mean(position), max(position)], [0 0.5 1], 0.1);
endfunction

%!test assert_spans (2*5.^(0:0.01:1), 2, 10);
%!error assert_spans (2*5.^(0:0.01:1), 2, 20);
%!error assert_spans (2*5.^(0:0.01:1), 1, 10);
%!error assert_spans ([2, 6, 11], 2, 10);
%!error assert_spans ([2, NaN, 10], 2, 10);
