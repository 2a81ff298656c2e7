## -*- texinfo -*-
## @deftypefn {} {@var{states} =} within_step (@var{points}, @var{h}, @var{y}, @var{a}, @var{power}, @var{x})
## The states (place; rate; work and what is dissipated) at the parts @var{x} (1-by-m) of a step of collocation of
## @var{h} (s) from the state @var{y} on, by the polynomials through the accelerations @var{a} (n-by-s) and the
## @var{power} (rows-by-s) at its @var{points} (s-by-1, parts of the step).
## @end deftypefn

function states = within_step (points, h, y, a, power, x)
  n = rows (a);
  p = 0:numel (points) - 1;
  coefficients = inv (points.^p).';
  once = coefficients*(x.^(p.' + 1)./(p.' + 1));
  twice = coefficients*(x.^(p.' + 2)./((p.' + 1).*(p.' + 2)));
  states = y + [h*y(n+1:2*n)*x + h^2*(a*twice); h*(a*once); h*(power*once)];
endfunction

%!test # an acceleration of 6 t and a power of 3 t^2 from t = 2 on, in a step of 4
%! points = [0.2; 0.5; 1];
%! t = @(x) 2 + 4*x;
%! states = within_step (points, 4, [8; 12; 8], 6*t(points.'), 3*t(points.').^2, [0 0.3 1]);
%! assert (states, [t([0 0.3 1]).^3; 3*t([0 0.3 1]).^2; t([0 0.3 1]).^3], 1e-12);
