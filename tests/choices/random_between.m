## -*- texinfo -*-
## @deftypefn {} {@var{x} =} random_between (@var{low}, @var{high})
## A random number from @var{low} to @var{high}, both positive, whose logarithm is uniform: each decade is as likely.
## @end deftypefn

function x = random_between (low, high)
  x = low*(high/low)^rand ();
endfunction

%!test # a tenth of the way in the logarithm has a tenth of the numbers
%! x = with_seed (1, @() arrayfun (@(k) random_between (1e-3, 1e7), 1:1000));
%! assert (min (x) >= 1e-3 && max (x) <= 1e7); assert (histc (log10 (x), -3:7)(1:10)/1000, 0.1*ones (1, 10), 0.04);
