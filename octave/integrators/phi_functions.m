## -*- texinfo -*-
## @deftypefn {} {@var{f} =} phi_functions (@var{z})
## The functions of exponential integrators, exp (z), (exp (z) - 1)/z and phi_k+1 = (phi_k - 1/k!)/z up to phi_3, of complex
## @var{z} (n-by-1) as the columns of @var{f} (n-by-4).
## @end deftypefn

function f = phi_functions (z)
  persistent divisors = factorial ((0:17) + (0:3).');
  f = exp (z);
  f(:,2) = (f(:,1) - 1)./z;
  f(:,3) = (f(:,2) - 1)./z;
  f(:,4) = (f(:,3) - 1/2)./z;
  small = abs (z) < 1;
  powers = z(small,1).^(0:17);
  for k = 1:4
    f(small,k) = sum (powers./divisors(k,:), 2);
  endfor
endfunction

%!assert (phi_functions (0), [1 1 1/2 1/6])
%!test # the series and the closed form meet
%! f = phi_functions ([0.9999999999; 1.0000000001]*exp (2i));
%! assert (f(1,:), f(2,:), 1e-9);
%!assert (phi_functions (-1e4)(2), 1e-4, 1e-12)
