## -*- texinfo -*-
## @deftypefn {} {@var{c} =} collocation (@var{s})
## The collocation method at the @var{s} points of Gauss (Butcher, Math. Comp. 18, 1964; order 2s, symplectic and
## stable for every oscillation): a struct of points (s-by-1), A (s-by-s, integrals of the polynomials to the points),
## AA = A*A, weights, second_weights (of the second integral, 1-by-s), onward (s-by-s: values at the next step's points)
## and nodes, the points and the step's ends.
## @end deftypefn

function c = collocation (s)
  [points, c.weights] = gauss_rule (s);
  c.points = points.';
  powers = 0:s-1;
  V = c.points.^powers;
  c.A = (c.points.^(powers + 1)./(powers + 1))/V;
  c.AA = c.A*c.A;
  c.second_weights = c.weights*c.A;
  c.onward = ((1 + c.points).^powers)/V;
  c.nodes = [0; c.points; 1];
endfunction

%!test # the method of two points
%! c = collocation (2);
%! assert (c.A, [1/4, 1/4 - sqrt(3)/6; 1/4 + sqrt(3)/6, 1/4], 1e-14);
%! assert (c.weights, [1 1]/2, 1e-14);
%! assert (c.onward*c.points, 1 + c.points, 1e-13);
%! assert (c.nodes, [0; c.points; 1]);
