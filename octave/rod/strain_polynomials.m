## -*- texinfo -*-
## @deftypefn {} {[@var{e}, @var{e_slope}, @var{chi}, @var{bend}] =} strain_polynomials (@var{n1}, @var{n2}, @var{xi}, @
##   @var{length})
## What stretches (@var{e}, 1/m) and what bends a rod of that @var{length} (m) as polynomials of Legendre of degrees 0
## to @var{n1} - 1 and 0 to @var{n2} - 1, n1 + n2 base functions, at the stations @var{xi} (p-by-1, m): p-by-n each,
## with the derivative of e, the turning of the tangent @var{chi} (1/m) and its derivative @var{bend}.  They are
## orthogonal in the strain energy of the straight rod.
## @end deftypefn

function [e, e_slope, chi, bend] = strain_polynomials (n1, n2, xi, length)
  [P, P_slope] = legendre_functions (max (n1, n2 + 1), xi, length);
  none_1 = zeros (numel (xi), n1);
  none_2 = zeros (numel (xi), n2);
  e = [P(:,1:n1)/length, none_2];
  e_slope = [P_slope(:,1:n1)/length, none_2];
  bend = [none_1, P(:,1:n2)/length^2];
  before = [zeros(numel (xi), 1), P];  # that the integral of the first is the second one less itself at O, is left out
  odd = 2*(1:n2) - 1;
  chi = [none_1, (P(:,2:n2+1) - before(:,1:n2))./(2*odd*length)];
endfunction

%!function change = strain_polynomials_at (of, xi)   # since O
%!  [e, ~, chi] = strain_polynomials (3, 4, [0; xi], 2);
%!  values = of (e, chi);
%!  change = values(2:end,:) - values(1,:);
%!endfunction
%!test # orthogonal, and each is the derivative of what is before it
%! axis = panels_between (linspace (0, 2, 3));
%! [e, e_slope, chi, bend] = strain_polynomials (3, 4, axis.xi.', 2);
%! for functions = {e, bend}
%!   products = functions{1}.'*(axis.weights.'.*functions{1});
%!   assert (products, diag (diag (products)), 1e-14);
%! endfor
%! between = integrals_to (axis, [0.3 1.9]);
%! assert (between*[e_slope, bend], strain_polynomials_at (@(e, chi) [e, chi], [0.3; 1.9]), 1e-14);
%!assert (size (strain_polynomials (0, 0, [0; 1], 1)), [2 0])
