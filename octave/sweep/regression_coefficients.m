## -*- texinfo -*-
## @deftypefn {} {[@var{beta}, @var{share}] =} regression_coefficients (@var{x}, @var{y})
## By how many of its standard deviations @var{y} (n-by-1) goes up where a column of @var{x} (n-by-d) does by one of
## its own and the others stay: the coefficients @var{beta} (1-by-d) of the linear regression of standardised numbers
## (Saltelli et al. 2008, Global Sensitivity Analysis, 1.2.5), and the @var{share} R^2 of the variance that it
## explains, without which they say little.  All are NaN where there are too few rows, or something does not vary on
## its own.
## @end deftypefn

function [beta, share] = regression_coefficients (x, y)
  [n, d] = size (x);
  [beta, share] = deal (NaN (1, d), NaN);
  spread = std ([x, y], 0, 1);
  if (n < d + 2 || any (spread == 0))
    return;
  endif
  x = (x - mean (x, 1))./spread(1:d);
  y = (y - mean (y))/spread(end);
  if (rank (x) == d)
    beta = (x \ y).';
    share = 1 - sumsq (y - x*beta.')/sumsq (y);
  endif
endfunction

%!test # a linear model of independent inputs: coefficient times spread over spread
%! x = latin_hypercube (struct ("low", {0, -1, 5}, "high", {1, 3, 6}), 200, 1);
%! y = 3 + 2*x(:,1) - x(:,2);
%! [beta, share] = regression_coefficients (x, y);
%! assert (beta, [2 -1 0].*std (x)/std (y), 1e-10); assert (share, 1, 1e-12);
%!test # a parabola has no slope
%! x = linspace (-1, 1, 101).';
%! [beta, share] = regression_coefficients (x, x.^2);
%! assert ([beta, share], [0 0], 1e-12);
%!test # what cannot be told apart
%! x = (1:5).';
%! for table = {[x, 2*x], [x, x.^0], [x, x.^2, x.^3, x.^4]}
%!   [beta, share] = regression_coefficients (table{1}, x.^2);
%!   assert ([beta, share], NaN (1, columns (table{1}) + 1));
%! endfor
%! assert (regression_coefficients (x, 0*x), NaN);
