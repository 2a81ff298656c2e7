## -*- texinfo -*-
## @deftypefn {} {@var{states} =} within_step (@var{points}, @var{h}, @var{y}, @var{a}, @var{power}, @var{x})
## The states (place; rate; work and what is dissipated) @var{x} (1-by-m) steps of collocation of @var{h} (s) after the
## first of the states @var{y} (a column a step), by the polynomials through the accelerations @var{a} (n-by-s a step)
## and the @var{power} (rows-by-s a step) at their @var{points} (s-by-1, parts of a step).
## @end deftypefn

function states = within_step (points, h, y, a, power, x)
  n = rows (a);
  s = numel (points);
  step = max (1, min (1 + floor (x*(1 + 4*eps)), columns (a)/s));
  x -= step - 1;
  p = 0:s-1;
  coefficients = inv (points.^p).';
  once = coefficients*(x.^(p.' + 1)./(p.' + 1));
  twice = coefficients*(x.^(p.' + 2)./((p.' + 1).*(p.' + 2)));
  states = y(:,step);
  states(1:n,:) += h*x.*y(n+1:2*n,step);
  for k = 1:s
    at = s*(step - 1) + k;
    states += [h^2*a(:,at).*twice(k,:); h*a(:,at).*once(k,:); h*power(:,at).*once(k,:)];
  endfor
endfunction

%!test # an acceleration of 6 t and a power of 3 t^2 from t = 2 on, in a step of 4
%! points = [0.2; 0.5; 1];
%! t = @(x) 2 + 4*x;
%! states = within_step (points, 4, [8; 12; 8], 6*t(points.'), 3*t(points.').^2, [0 0.3 1]);
%! assert (states, [t([0 0.3 1]).^3; 3*t([0 0.3 1]).^2; t([0 0.3 1]).^3], 1e-12);
%!test # and of two such steps in turn
%! points = [0.2; 0.5; 1];
%! now = 2 + 4*[points.', 1 + points.'];
%! starts = [8 216; 12 108; 8 216];
%! states = within_step (points, 4, starts, 6*now, 3*now.^2, [1 1.3 1.9 2]);
%! t = [6, 7.2, 9.6, 10];
%! assert (states, [t.^3; 3*t.^2; t.^3], 1e-10);
