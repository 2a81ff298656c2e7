## -*- texinfo -*-
## @deftypefn {} {[@var{first}, @var{second}] =} oscillator_roots (@var{omega}, @var{damping}, @var{tau})
## The roots of s^2 + @var{damping} s + @var{omega}^2 (n-by-1 each, 1/s and rad/s): pairs, the upper one first, or two
## real ones, kept apart a little for the times @var{tau} (s), since what they do is divided by their difference.
## @end deftypefn

function [first, second] = oscillator_roots (omega, damping, tau)
  root = sqrt (complex (damping.^2/4 - omega.^2));
  close = abs (root).*tau < 1e-5;
  root(close) = 1e-8i./tau(close);
  first = -damping/2 + root;
  second = -damping/2 - root;
  overdamped = ! close & imag (root) == 0;
  first(overdamped) = omega(overdamped).^2./second(overdamped);
endfunction

%!test
%! [first, second] = oscillator_roots ([2; 3; 3], [0; 10; 6], [1; 1; 1]);
%! assert (first, [2i; -1; -3], 2e-8); assert (second, [-2i; -9; -3], 2e-8);
%!assert (oscillator_roots (1e-3, 1e6, 1), complex (-1e-12), 1e-24)  # which the difference of the other two would lose
