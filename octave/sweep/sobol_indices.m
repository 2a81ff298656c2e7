## -*- texinfo -*-
## @deftypefn {} {[@var{index}, @var{error}, @var{degree}] =} sobol_indices (@var{x}, @var{y})
## The share of the variance of @var{y} (n-by-1) that each column of @var{x} (n-by-d) has alone, Sobol's indices of
## first order (1993), where the columns are independent and uniform from -1 to 1, and the standard @var{error} of
## each.
##
## They are those of the sum of Legendre polynomials of each column that fits the given points best (Li, Wang and
## Rabitz 2002, RS-HDMR; Sudret 2008): to that @var{degree} of up to 12, at most a third as many terms as points, with
## which the points are predicted best by the others.  What is not such a sum, interactions above all, is in no index.
## Bias and error are those of the jackknife (Efron and Stein 1981), in which a point less moves the coefficients by
## what its residual and leverage say; that the points of a Latin hypercube are spread evenly makes them better than
## that by a third or so.  All are NaN where there are too few points, or @var{y} does not vary.
## @end deftypefn

function [index, error, degree] = sobol_indices (x, y)
  [n, d] = size (x);
  [index, error, degree] = deal (NaN (1, d), NaN (1, d), NaN);
  degrees = 1:min (12, floor ((n/3 - 1)/d));
  if (isempty (degrees) || range (y) == 0)
    return;
  endif
  fits = arrayfun (@(degree) fit_of (x, y, degree), degrees, "uniformoutput", false);
  [~, degree] = min (cellfun (@(fit) fit.predicted, fits));
  fit = fits{degree};

  without = fit.coefficients - fit.inverse.*fit.left_out.';
  squares = fit.squares - fit.residual.'.*fit.left_out.';
  whole = shares_of (fit.coefficients, fit.squares, n, d);
  less = shares_of (without, squares, n - 1, d);
  index = (n*whole - (n - 1)*mean (less, 2)).';
  error = sqrt ((n - 1)*mean ((less - mean (less, 2)).^2, 2)).';
endfunction

## least squares, and the residual that each point has where the others are fitted
function fit = fit_of (x, y, degree)
  [n, d] = size (x);
  polynomials = legendre_functions (degree + 1, x + 1, 2).*sqrt (2*(0:degree) + 1);
  A = [ones(n, 1), reshape(polynomials(:,2:end), n, d*degree)];
  [Q, R] = qr (A, 0);
  fit.inverse = R \ Q.';
  fit.coefficients = fit.inverse*y;
  fit.residual = y - A*fit.coefficients;
  fit.squares = sumsq (fit.residual);
  fit.left_out = fit.residual./max (1 - sumsq (Q, 2), 1e-9);
  fit.predicted = sumsq (fit.left_out);
endfunction

## of the variance, by columns of coefficients of so many rows; the polynomials have unit variance
function shares = shares_of (coefficients, squares, n, d)
  m = rows (coefficients);
  parts = squeeze (sum (reshape (coefficients(2:end,:).^2, d, [], columns (coefficients)), 2));
  parts = reshape (parts, d, []);
  shares = parts./(sum (parts, 1) + squares/(n - m));
endfunction

%!function [index, error] = of (f, n, d, seed)
%!  x = latin_hypercube (struct ("low", num2cell (-ones (1, d)), "high", 1), n, seed);
%!  [index, error] = sobol_indices (x, f (x));
%!endfunction
%!test # a linear model: the squares of the standardised coefficients
%! [index, error] = of (@(x) 2*x(:,1) - x(:,2) + 0.5*x(:,3), 60, 3, 1);
%! assert (index, [4 1 0.25]/5.25, 1e-10); assert (error, [0 0 0], 1e-10);
%!test # Ishigami and Homma 1990, a = 7, b = 0.1, by its closed form: within three standard errors, which are small
%! [a, b] = deal (7, 0.1);
%! parts = [(1 + b*pi^4/5)^2/2, a^2/8, 0];
%! expected = parts/(sum (parts) + b^2*pi^8*(1/18 - 1/50));
%! assert (expected, [0.3139 0.4424 0], 5e-5);
%! ishigami = @(x) sin (pi*x(:,1)) + a*sin (pi*x(:,2)).^2 + b*(pi*x(:,3)).^4.*sin (pi*x(:,1));
%! for seed = 1:20
%!   [index, error] = of (ishigami, 1000, 3, seed);
%!   assert (abs (index - expected) < 3*error + 1e-3); assert (error < 0.03);
%! endfor
%!test # there is no bias, and the error is that of the scatter, or more, since a hypercube's points are spread evenly
%! product = @(x) (1 + x(:,1)).*(1 + x(:,2));   # each 1/3, together 1/9: 3/7 of the variance
%! [index, error] = arrayfun (@(seed) of (product, 60, 2, seed), 1:200, "uniformoutput", false);
%! [index, error] = deal (vertcat (index{:}), vertcat (error{:}));
%! assert (mean (index), [3 3]/7, 0.01); assert (mean (error)./std (index), [1.5 1.5], 0.5);
%!test # too few, and what does not vary
%! assert (of (@(x) x(:,1), 5, 2, 1), [NaN NaN]); assert (of (@(x) 0*x(:,1), 50, 2, 1), [NaN NaN]);
