## -*- texinfo -*-
## @deftypefn {} {@var{f} =} phi_functions (@var{z}, @var{last})
## The functions of exponential integrators, exp (z), (exp (z) - 1)/z and phi_k+1 = (phi_k - 1/k!)/z up to phi_last, of
## complex @var{z} (n-by-1) as the columns of @var{f} (n-by-(last + 1)).
## @end deftypefn

function f = phi_functions (z, last)
  factorials = [1, cumprod(1:last)];
  f = [exp(z), zeros(rows (z), last)];
  for k = 1:last
    f(:,k+1) = (f(:,k) - 1/factorials(k))./z;
  endfor
  small = abs (z) < last/2;  # where that would lose digits
  if (any (small))
    f(small,:) = series (z(small), last);
  endif
endfunction

function f = series (z, last)
  f = ones (rows (z), last + 1);
  for j = 20+2*last:-1:1
    f = 1 + z./(j + (0:last)).*f;
  endfor
  f ./= [1, cumprod(1:last)];
endfunction

%!assert (phi_functions (0, 3), [1 1 1/2 1/6])
%!test # the series and the closed form meet
%! for last = [3 8]
%!   f = phi_functions ((last/2 + [-1e-10; 1e-10])*exp (2i), last);
%!   assert (f(1,:), f(2,:), 1e-9);
%! endfor
%!assert (phi_functions (-1e4, 3)(2), 1e-4, 1e-12)
