## -*- texinfo -*-
## @deftypefn {} {@var{c} =} stumpff (@var{x})
## Stumpff's functions c_0 to c_4 of @var{x} = z^2 >= 0 (n-by-1) as the columns of @var{c} (n-by-5): cos z, sin z/z, and
## c_k+2 = (1/k! - c_k)/z^2.  Integrals of s^(k-1)/(k-1)! cos ((1-s) z) over 0 <= s <= 1 are c_k.
## @end deftypefn

function c = stumpff (x)
  z = sqrt (x);
  c = [cos(z), sin(z)./z, zeros(rows (x), 3)];
  c(:,3) = (1 - c(:,1))./x;
  c(:,4) = (1 - c(:,2))./x;
  c(:,5) = (1/2 - c(:,3))./x;
  small = x < 1;
  if (any (small))
    c(small,:) = series (x(small));
  endif
endfunction

function c = series (x)
  persistent divisors = factorial (2*(0:9) + (0:4).');
  powers = (-x).^(0:9);
  c = zeros (rows (x), 5);
  for k = 1:5
    c(:,k) = sum (powers./divisors(k,:), 2);
  endfor
endfunction

%!test # the series and the closed form meet, and an integral
%! c = stumpff ([0.999999999; 1.000000001]);
%! assert (c(1,:), c(2,:), 1e-9);
%! c = stumpff (4);
%! assert (c(4), quadgk (@(s) s.^2/2.*cos ((1 - s)*2), 0, 1), 1e-12);
%!assert (stumpff (0), [1 1 1/2 1/6 1/24], 1e-15)
