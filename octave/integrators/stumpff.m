## -*- texinfo -*-
## @deftypefn {} {@var{c} =} stumpff (@var{x}, @var{last})
## Stumpff's functions c_0 to c_last of @var{x} = z^2 >= 0 (n-by-1) as the columns of @var{c} (n-by-(last + 1)): cos z,
## sin z/z, and c_k+2 = (1/k! - c_k)/z^2.  Integrals of s^(k-1)/(k-1)! cos ((1-s) z) over 0 <= s <= 1 are c_k.
## @end deftypefn

function c = stumpff (x, last)
  z = sqrt (x);
  c = [cos(z), sin(z)./z, zeros(rows (x), last - 1)];
  factorials = [1, cumprod(1:last)];
  for k = 3:last+1
    c(:,k) = (1/factorials(k-2) - c(:,k-2))./x;
  endfor
  small = x < last^2/4;  # where that would lose digits
  if (any (small))
    c(small,:) = series (x(small), last);
  endif
endfunction

function c = series (x, last)
  c = ones (rows (x), last + 1);
  for j = 10+last:-1:1
    c = 1 - x./((2*j + (0:last)).*(2*j - 1 + (0:last))).*c;
  endfor
  c ./= [1, cumprod(1:last)];
endfunction

%!test # the series and the closed form meet, and an integral
%! for last = [4 9]
%!   c = stumpff (last^2/4 + [-1e-9; 1e-9], last);
%!   assert (c(1,:), c(2,:), 1e-9);
%! endfor
%! c = stumpff (4, 4);
%! assert (c(4), quadgk (@(s) s.^2/2.*cos ((1 - s)*2), 0, 1), 1e-12);
%!assert (stumpff (0, 4), [1 1 1/2 1/6 1/24], 1e-15)
%!assert (stumpff (100, 9)(10), (1/5040 - (1/120 - (1/6 - (1 - sin (10)/10)/100)/100)/100)/100, 1e-18)
