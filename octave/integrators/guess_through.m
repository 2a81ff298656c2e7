## -*- texinfo -*-
## @deftypefn {} {[@var{a}, @var{starts}, @var{nodes}] =} guess_through (@var{method}, @var{h}, @var{n}, @var{states})
## A first guess for @code{collocation_stages} of steps of @var{h} (s) of a collocation @var{method} (see
## @code{collocation}) through the @var{states} (@var{n} places, their velocities, and more; k a step) at the
## @var{nodes} of each step, its ends and stages (parts of it, k-by-1): accelerations @var{a} (n-by-s a step) by the
## polynomials through the places, and the states at the @var{starts} (2n-by-steps).
## @end deftypefn

function [a, starts, nodes] = guess_through (method, h, n, states)
  nodes = unique ([0; method.points; 1]);
  p = 0:numel (nodes) - 1;
  twice = p.*(p - 1).*method.points.^max (p - 2, 0);
  weights = (twice/nodes.^p).';
  a = states(1:n,:)*kron (eye (columns (states)/numel (nodes)), weights)/h^2;
  starts = states(1:2*n,1:numel (nodes):end);
endfunction

%!test # of cubics in two steps, with and without a stage at the end
%! for points = {collocation(4).points, radau_rule(3).c.'}
%!   method = struct ("points", points{1});
%!   [~, ~, nodes] = guess_through (method, 1, 0, []);
%!   assert (nodes([1 end]), [0; 1]); assert (numel (nodes), 4 + 2*(numel (method.points) == 4));
%!   t = 0.1*[nodes; nodes + 1].';
%!   [a, starts] = guess_through (method, 0.1, 2, [t.^3; 2 - t.^2; 3*t.^2; -2*t; 7 + 0*t]);
%!   at = 0.1*[method.points; method.points + 1].';
%!   assert (a, [6*at; -2 + 0*at], 1e-10);
%!   assert (starts, [0 1e-3; 2 1.99; 0 0.03; 0 -0.2], 1e-15);
%! endfor
