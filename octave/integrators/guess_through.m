## -*- texinfo -*-
## @deftypefn {} {[@var{a}, @var{starts}] =} guess_through (@var{method}, @var{h}, @var{n}, @var{states})
## A first guess for @code{collocation_stages} of steps of @var{h} (s) of a collocation @var{method} (see
## @code{collocation}) through the @var{states} (@var{n} places, their velocities, and more) at the nodes of each step:
## accelerations @var{a} (n-by-s a step) by the polynomials through the places, and the states at the @var{starts}
## (2n-by-steps).
## @end deftypefn

function [a, starts] = guess_through (method, h, n, states)
  k = numel (method.nodes);
  p = 0:k - 1;
  twice = p.*(p - 1).*method.points.^max (p - 2, 0);
  weights = (twice/method.nodes.^p).';
  a = states(1:n,:)*kron (eye (columns (states)/k), weights)/h^2;
  starts = states(1:2*n,1:k:end);
endfunction

%!test # of cubics in two steps, with and without a stage at the end
%! for method = {collocation(4), struct("points", radau_rule (3).c.', "nodes", [0; radau_rule(3).c.'])}
%!   method = method{1};
%!   t = 0.1*[method.nodes; method.nodes + 1].';
%!   [a, starts] = guess_through (method, 0.1, 2, [t.^3; 2 - t.^2; 3*t.^2; -2*t; 7 + 0*t]);
%!   at = 0.1*[method.points; method.points + 1].';
%!   assert (a, [6*at; -2 + 0*at], 1e-10);
%!   assert (starts, [0 1e-3; 2 1.99; 0 0.03; 0 -0.2], 1e-15);
%! endfor
