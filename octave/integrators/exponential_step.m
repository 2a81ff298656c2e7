## -*- texinfo -*-
## @deftypefn {} {@var{step} =} exponential_step (@var{omega}, @var{damping}, @var{h}, @var{extra})
## The functions of an exponential method's step @var{h} (s) for oscillators eta_ddot + damping eta_dot + omega^2 eta (n-by-1
## each, rad/s and 1/s) in the form z = (eta; eta_dot; w) with @var{extra} states w.
##
## Fields: h, swap, and half and whole, with what z becomes over h/2 and h by itself and by a load R that is constant,
## linear and quadratic in time: free, phi1, phi2, phi3, each of two columns for z.*first + z(swap).*second.
## @end deftypefn

function step = exponential_step (omega, damping, h, extra)
  n = numel (omega);
  step.h = h;
  step.swap = [n+1:2*n, 1:n, 2*n+(1:extra)];
  step.half = motion (omega, damping, h/2, extra);
  step.whole = motion (omega, damping, h, extra);
endfunction

function f = motion (omega, damping, h, extra)
  if (any (damping))
    [same, other] = damped (omega, damping, h);
  else
    c = stumpff ((omega*h).^2);
    [same, other] = deal ({c(:,1:4), c(:,1:4)}, h*c(:,2:5));
  endif
  names = {"free", "phi1", "phi2", "phi3"};
  for k = 0:3
    scale = h^(k > 0);
    constant = scale/[1 1 2 6](k+1);
    f.(names{k+1}) = [[scale*same{1}(:,k+1); scale*same{2}(:,k+1); ones(extra, 1)*constant], ...
                      [scale*other(:,k+1); -scale*omega.^2.*other(:,k+1); zeros(extra, 1)]];
  endfor
endfunction

## The matrix functions of A = [0 1; -omega^2 -damping] from those of its eigenvalues, which are kept apart a little.
function [same, other] = damped (omega, damping, h)
  root = sqrt (complex (damping.^2/4 - omega.^2));
  close = abs (root)*h < 1e-5;
  root(close) = 1e-5i/h;
  first = -damping/2 + root;
  second = -damping/2 - root;
  second(! close) = omega(! close).^2./first(! close);
  swapped = abs (second) > abs (first) & ! close & imag (root) == 0;
  second(swapped) = -damping(swapped)/2 - root(swapped);
  first(swapped) = omega(swapped).^2./second(swapped);
  [f1, f2] = deal (phi_functions (h*first), phi_functions (h*second));
  gap = first - second;
  same = {real((f2.*first - f1.*second)./gap), real((f1.*first - f2.*second)./gap)};
  other = real ((f1 - f2)./gap);
endfunction

%!function z = after (step, f, z)
%!  z = f(:,1).*z + f(:,2).*z(step.swap);
%!endfunction
%!test # a quarter of a turn, and rest under a constant load
%! step = exponential_step (2, 0, pi/4, 1);
%! z = after (step, step.whole.free, [1; 0; 5]);
%! assert (z, [0; -2; 5], 1e-14);
%! assert (z + after (step, step.whole.phi1, [0; 4; 3]), [1; 0; 5 + 3*pi/4], 1e-14);
%!test # damped, weakly, critically and strongly, and without any hold: as the matrix exponential has it
%! [omega, damping, h] = deal ([2; 3; 3; 50; 0], [0.3; 6; 40; 1e5; 0], 0.7);
%! step = exponential_step (omega, damping, h, 0);
%! for k = 1:5
%!   A = [0 1; -omega(k)^2, -damping(k)];
%!   B = expm (h*[A, eye(2), zeros(2, 4); zeros(2, 4), eye(2), zeros(2); zeros(2, 6), eye(2); zeros(2, 8)]);
%!   here = {B(:,1:2), B(:,3:4), B(:,5:6)/h, B(:,7:8)/h^2};
%!   names = {"free", "phi1", "phi2", "phi3"};
%!   for i = 1:4
%!     f = step.whole.(names{i})([k, k+5],:);
%!     assert ([f(1,1), f(1,2); f(2,2), f(2,1)], here{i}(1:2,:), 1e-8*max (abs (here{i}(1:2,:)(:))));
%!   endfor
%! endfor
