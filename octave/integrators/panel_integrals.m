## -*- texinfo -*-
## @deftypefn {} {@var{I} =} panel_integrals (@var{z}, @var{x}, @var{m})
## The integrals of exp (@var{z}*(x - s)) T_i (2 s - 1) over s from 0 to x, for each row of the complex @var{z} (n-by-1)
## and of @var{x} (n-by-1, 0 to 1): what Chebyshev's polynomials of the degrees i = 0 to @var{m} - 1, as loads on a
## panel, do to what grows or turns as exp (z*s); n-by-m.
##
## Up to abs (z*x) = 25 by Gauss's rule of 28 points, which is exact to rounding there, beyond by parts: the derivatives
## at both ends by the powers of 1/z.  Both are free of the cancellation that the powers of s have.
## @end deftypefn

function I = panel_integrals (z, x, m)
  persistent points weights;
  if (isempty (points))
    [points, weights] = gauss_rule (28);
  endif
  I = zeros (rows (z), m);
  far = abs (z.*x) > 25;
  if (any (! far))
    I(! far,:) = by_quadrature (z(! far), x(! far), m, points, weights);
  endif
  if (any (far))
    I(far,:) = by_parts (z(far), x(far), m);
  endif
endfunction

function I = by_quadrature (z, x, m, points, weights)
  kernel = x.*weights.*exp (z.*x.*(1 - points));
  angle = acos (2*x.*points - 1);
  I = zeros (rows (z), m);
  for i = 0:m-1
    I(:,i+1) = sum (kernel.*cos (i*angle), 2);
  endfor
endfunction

## sum over k of (exp (z x) T^(k) (start) - T^(k) (x))/z^(k+1), by Horner's rule
function I = by_parts (z, x, m)
  D = derivatives (m);
  at_x = cos ((0:m-1).*acos (2*x - 1));
  at_start = (-1).^(0:m-1);
  power = cell (1, m);
  power{1} = eye (m);
  for k = 2:m
    power{k} = power{k-1}*D;
  endfor
  I = 0;
  for k = m:-1:1
    I = (I + exp (z.*x).*(at_start*power{k}) - at_x*power{k})./z;
  endfor
endfunction

## of Chebyshev's polynomials in 2 s - 1 by s: column i has T_i' in the T
function D = derivatives (m)
  D = zeros (m);
  for i = 1:m-1
    of = i-1:-2:0;
    D(of+1,i+1) = 4*i;
    D(1,i+1) /= 1 + (mod (i, 2) == 1);
  endfor
endfunction

%!test # as adaptive quadrature has them, on both sides of 25, growing and fading, and on a part of the panel
%! for z = [0, 2i, 24.9i, 25.1i, 400i, -3, -24.9, -25.1, -1e3, -10+40i]
%!   for x = [1 0.3]
%!     I = panel_integrals (z, x, 8);
%!     for i = 0:7
%!       part = @(f) quadgk (@(s) f (exp (z*(x - s)).*cos (i*acos (2*s - 1))), 0, x, "AbsTol", 1e-13, "RelTol", 0);
%!       assert (I(i+1), part (@real) + 1i*part (@imag), 1e-13);
%!     endfor
%!   endfor
%! endfor
%!test # all digits of a response to T_0, (exp (z) - 1)/z, from still to fast
%! z = 1i*[1e-9; 1e-3; 1; 30; 1e3; 1e6];
%! assert (panel_integrals (z, ones (6, 1), 8)(:,1), expm1 (z)./z, -1e-14);
