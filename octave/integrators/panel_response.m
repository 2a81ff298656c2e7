## -*- texinfo -*-
## @deftypefn {} {[@var{free}, @var{forced}] =} panel_response (@var{modal}, @var{h}, @var{x}, @var{weights}, @
##   @var{extra})
## What a state z of @code{modal_form} with @var{extra} states w becomes at the fractions @var{x} (1-by-k, increasing)
## of a panel of @var{h} (s): free*z + forced.'*remainders, (R k)-by-R and (R m)-by-(R k), sparse, with R = rows (z).
## The remainders stand below each other, (R m)-by-1, from the first node to the last; @var{weights} (m-by-m) times a
## column of values at the nodes gives the coefficients of Chebyshev's polynomials of 0 to 1 (see
## @code{panel_integrals}).
## @end deftypefn

function [free, forced] = panel_response (modal, h, x, weights, extra)
  n = modal.n;
  m = rows (weights);
  k = numel (x);
  times_k = ones (k, 1);
  omega = kron (times_k, modal.omega);
  damping = kron (times_k, modal.damping);
  [same, other, constant] = responses (modal, h, x, weights);
  constant = kron (constant, ones (extra, 1));

  R = 2*n + extra;
  first_row = (0:k-1)*R;
  coordinate = ((1:n).' + first_row)(:);
  follower = ((2*n+1:R).' + first_row)(:);
  of_coordinate = kron (times_k, (1:n).');
  of_follower = kron (times_k, (2*n+1:R).');
  free = blocks (coordinate, of_coordinate, n, same(:,1), other(:,1), omega, damping, follower, of_follower, ...
                 ones (k*extra, 1), R*k, R);
  node = R*(0:m-1);
  forced = blocks (coordinate, of_coordinate + node, n, same(:,2:end), other(:,2:end), omega, damping, ...
                   follower, of_follower + node, constant, R*k, R*m).';
endfunction

## what a state, the first column, and unit loads at the nodes, the others, become: same + other*A of each mode, with
## A = [0 1; -omega^2 -damping], n fractions below each other, and constant, what only follows the loads
function [same, other, constant] = responses (modal, h, x, weights)
  [first, second] = oscillator_roots (modal.omega, modal.damping, h*ones (modal.n, 1));
  f = of_roots (h, [first; 0], x, weights);  # the root 0: what only follows
  every = modal.n + 1;
  constant = real (f(every:every:end,2:end));
  f(every:every:end,:) = [];
  ## a pair of complex roots: f (root) = same + other*root
  root = first(:,ones (1, numel (x)))(:);
  other = imag (f)./imag (root);
  same = real (f) - real (root).*other;
  real_ones = imag (first) == 0;
  if (any (real_ones))
    here = repmat (real_ones, numel (x), 1);
    slow = root(here);
    slow_f = real (f(here,:));
    fast = repmat (second(real_ones), numel (x), 1);
    fast_f = real (of_roots (h, second(real_ones), x, weights));
    same(here,:) = (fast_f.*slow - slow_f.*fast)./(slow - fast);
    other(here,:) = (slow_f - fast_f)./(slow - fast);
  endif
endfunction

## exp (root*t) and its integrals over the loads, all roots of a fraction below each other
function f = of_roots (h, roots, x, weights)
  f = [exp(h*roots*x)(:), h*panel_integrals(h*roots, x, rows (weights))*weights];
endfunction

## same + other*A for the modes, the constants for what follows
function S = blocks (row, column, n, same, other, omega, damping, follower, of_follower, constant, height, width)
  every = ones (1, columns (column));
  row = row(:,every);
  follower = follower(:,every);
  S = sparse ([row(:); row(:); row(:) + n; row(:) + n; follower(:)], ...
              [column(:); column(:) + n; column(:); column(:) + n; of_follower(:)], ...
              [same(:); other(:); (-omega.^2.*other)(:); (same - damping.*other)(:); constant(:)], height, width);
endfunction

%!test # a load that grows as the square of time, on an oscillator, a free mass and a damper, and a state that follows
%! modal = struct ("n", 3, "omega", [2; 0; 0], "damping", [0; 0; 3]);
%! nodes = [0 0.3 1];
%! weights = inv (cos (acos (2*nodes.' - 1).*(0:2)));
%! [free, forced] = panel_response (modal, 0.7, [0.4 1], weights, 1);
%! load = kron (nodes.'.^2, [0; 0; 0; 1; 1; 1; 1]);
%! z = free*[1; 2; 3; 4; 5; 6; 7] + forced.'*load;
%! for k = 1:2
%!   t = 0.7*[0.4 1](k);
%!   part = @(f) quadgk (@(s) f (t - s).*(s/0.7).^2, 0, t);
%!   exact = [cos(2*t) + 2*sin(2*t) + part(@(s) sin (2*s)/2)
%!            2 + 5*t + part(@(s) s)
%!            3 + 2*(1 - exp (-3*t)) + part(@(s) (1 - exp (-3*s))/3)
%!            -2*sin(2*t) + 4*cos(2*t) + part(@(s) cos (2*s))
%!            5 + part(@(s) 1 + 0*s)
%!            6*exp(-3*t) + part(@(s) exp (-3*s))
%!            7 + part(@(s) 1 + 0*s)];
%!   assert (z(7*(k-1)+(1:7)), exact, 1e-13);
%! endfor
