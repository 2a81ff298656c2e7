## -*- texinfo -*-
## @deftypefn {} {[@var{values}, @var{slopes}, @var{seconds}] =} legendre_functions (@var{n}, @var{xi}, @var{length})
## The first @var{n} polynomials of Legendre on [0, @var{length}] (m), and their first and second derivatives, at the
## stations @var{xi} (p-by-1, m): p-by-n, in 1, 1/m and 1/m^2.
## @end deftypefn

function [values, slopes, seconds] = legendre_functions (n, xi, length)
  x = 2*xi(:)/length - 1;
  values = slopes = seconds = zeros (numel (x), n);
  values(:,1) = 1;
  if (n > 1)
    values(:,2) = x;
    slopes(:,2) = 1;
  endif
  for k = 2:n-1
    values(:,k+1) = ((2*k - 1)*x.*values(:,k) - (k - 1)*values(:,k-1))/k;
    slopes(:,k+1) = (2*k - 1)*values(:,k) + slopes(:,k-1);
    seconds(:,k+1) = (2*k - 1)*slopes(:,k) + seconds(:,k-1);
  endfor
  slopes *= 2/length;
  seconds *= (2/length)^2;
endfunction

%!test # P_3 = (5 x^3 - 3 x)/2 on [0, 2], where x = xi - 1
%! [values, slopes, seconds] = legendre_functions (4, [0; 1.5; 2], 2);
%! x = [-1; 0.5; 1];
%! assert (values(:,4), (5*x.^3 - 3*x)/2, 1e-14);
%! assert (slopes(:,4), (15*x.^2 - 3)/2, 1e-14);
%! assert (seconds(:,4), 15*x, 1e-13);
