## -*- texinfo -*-
## @deftypefn {} {@var{I} =} panel_integrals (@var{z}, @var{x}, @var{m})
## The integrals of exp (@var{z}*(x - s)) T_i (2 s - 1) over s from 0 to x, for each complex z (n-by-1) and each
## fraction of @var{x} (1-by-k, 0 to 1): what Chebyshev's polynomials of the degrees i = 0 to @var{m} - 1, as loads on
## a panel, do to what grows or turns as exp (z*s); (n k)-by-m, all z of a fraction below each other.
##
## Up to abs (z*x) = 16 by Gauss's rule of 20 points, which is exact to rounding there, beyond by parts: the
## derivatives at both ends by the powers of 1/z.  Both are free of the cancellation that the powers of s have.
## @end deftypefn

function I = panel_integrals (z, x, m)
  exponents = z*x;
  I = by_quadrature (exponents, x, m);
  far = find (abs (exponents) > 16);
  if (! isempty (far))
    of_row = x(ceil (far/rows (z))).'(:);
    I(far,:) = of_row.*by_parts (exponents(far)(:), of_row, m);
  endif
endfunction

## all fractions in one product: a block of points by polynomials each
function I = by_quadrature (exponents, x, m)
  persistent points weights;
  if (isempty (points))
    [points, weights] = gauss_rule (20);
  endif
  p = numel (points);
  k = numel (x);
  n = rows (exponents);
  block = ones (p, 1)*(1:k);
  kernel = exp (exponents(:,block(:)).*(1 - points)(ones (1, k),:).'(:).');
  T = (weights.'*x)(:).*cos (acos (2*(points.'*x)(:) - 1)*(0:m-1));
  T = sparse ((1:p*k).'*ones (1, m), block(:)*m + (1 - m:0), T, p*k, m*k);
  I = reshape (permute (reshape (kernel*T, n, m, k), [1 3 2]), n*k, m);
endfunction

## sum over k of (exp (z) T^(k) (start) - T^(k) (x)) x^k/z^(k+1)
function I = by_parts (z, x, m)
  persistent powers at_start;
  if (columns (powers) != m)
    [powers, at_start] = derivatives (m);
  endif
  at_x = cos (acos (2*x - 1)*(0:m-1));
  inverse = cumprod ([1./z, (x./z)(:,ones (1, m-1))], 2);
  every = reshape (at_x.*reshape (inverse, [], 1, m), [], m*m);
  I = (exp (z).*inverse)*at_start - every*powers;
endfunction

## those of the orders 0 to m - 1 of Chebyshev's polynomials in 2 s - 1 by s: below each other, column i has those of
## T_i in the polynomials; and at s = 0, a row an order
function [powers, at_start] = derivatives (m)
  D = zeros (m);
  for i = 1:m-1
    of = i-1:-2:0;
    D(of+1,i+1) = 4*i;
    D(1,i+1) /= 1 + mod (i, 2);
  endfor
  powers = at_start = [];
  power = eye (m);
  for k = 1:m
    powers = [powers; power];
    at_start = [at_start; (-1).^(0:m-1)*power];
    power *= D;
  endfor
endfunction

%!test # as adaptive quadrature has them, on both sides of 16, growing and fading, and on a part of the panel
%! for z = [0, 2i, 15.9i, 16.1i, 400i, -3, -15.9, -16.1, -1e3, -10+40i]
%!   both = panel_integrals ([z; 5], [1 0.3], 8)([1 3],:);
%!   for k = 1:2
%!     [I, x] = deal (both(k,:), [1 0.3](k));
%!     for i = 0:7
%!       part = @(f) quadgk (@(s) f (exp (z*(x - s)).*cos (i*acos (2*s - 1))), 0, x, "AbsTol", 1e-13, "RelTol", 0);
%!       assert (I(i+1), part (@real) + 1i*part (@imag), 1e-13);
%!     endfor
%!   endfor
%! endfor
%!test # all digits of a response to T_0, (exp (z) - 1)/z, from still to fast
%! z = 1i*[1e-9; 1e-3; 1; 30; 1e3; 1e6];
%! assert (panel_integrals (z, 1, 8)(:,1), expm1 (z)./z, -1e-14);
%!test # one z and several fractions, as for several z
%! assert (panel_integrals (-1e3, [0.3 1], 8), panel_integrals ([-1e3; 5], [0.3 1], 8)([1 3],:), 1e-18);
