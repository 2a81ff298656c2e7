## -*- texinfo -*-
## @deftypefn {} {[@var{same}, @var{other}] =} oscillator_functions (@var{omega}, @var{damping}, @var{tau}, @var{last})
## phi_k (tau A), k = 0 to @var{last} (see @code{phi_functions}), of A = [0 1; -omega^2 -damping], the matrix of an
## oscillator: @var{same}(:,k+1) times the unit matrix plus @var{other}(:,k+1) times A, a row for each of the
## @var{omega}, @var{damping} and @var{tau} (n-by-1, rad/s, 1/s, s).
## @end deftypefn

function [same, other] = oscillator_functions (omega, damping, tau, last)
  if (any (damping))
    [same, other] = damped (omega, damping, tau, last);
  else
    c = stumpff ((omega.*tau).^2, last + 1);
    [same, other] = deal (c(:,1:last+1), tau.*c(:,2:last+2));
  endif
endfunction

## from the functions of the eigenvalues
function [same, other] = damped (omega, damping, tau, last)
  [first, second] = oscillator_roots (omega, damping, tau);
  [f1, f2] = deal (phi_functions (tau.*first, last), phi_functions (tau.*second, last));
  gap = first - second;
  same = real ((f2.*first - f1.*second)./gap);
  other = real ((f1 - f2)./gap);
endfunction

%!test # undamped, damped weakly, critically and strongly, and without any hold: as the matrix exponential has it
%! [omega, damping, tau] = deal ([2; 2; 3; 3; 50; 0; 0], [0; 0.3; 6; 40; 1e5; 0; 5], 0.7);
%! for k = 1:7
%!   A = [0 1; -omega(k)^2, -damping(k)];
%!   B = expm (tau*[A, eye(2), zeros(2, 4); zeros(2, 4), eye(2), zeros(2); zeros(2, 6), eye(2); zeros(2, 8)]);
%!   here = {B(1:2,1:2), B(1:2,3:4)/tau, B(1:2,5:6)/tau^2, B(1:2,7:8)/tau^3};
%!   [same, other] = oscillator_functions (omega(k), damping(k), tau, 3);
%!   for i = 1:4
%!     assert (same(i)*eye (2) + other(i)*A, here{i}, 1e-8*max (abs (here{i}(:))));
%!   endfor
%! endfor
