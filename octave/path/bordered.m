## -*- texinfo -*-
## @deftypefn {} {@var{dx} =} bordered (@var{linear}, @var{load}, @var{normal}, @var{force}, @var{along})
## The change @var{dx} = [dq; dfactor] (n+1-by-1), of those that the constraints leave free, for which the stiffness
## of @var{linear} (see @code{held_tangent}) carries the @var{load} (n-by-1) times dfactor and the @var{force} (p-by-1,
## on what is free), and @code{normal.'*dx} is @var{along}; NaN where there is none.
## @end deftypefn

function dx = bordered (linear, load, normal, force, along)
  warning ("off", "Octave:singular-matrix", "local");  # the shortest change is taken then, if there is one
  warning ("off", "Octave:nearly-singular-matrix", "local");
  Z = linear.basis;
  matrix = [linear.K, -Z.'*load; normal(1:end-1).'*Z, normal(end)];
  scale = max (max (abs (matrix), [], 2), realmin);
  matrix ./= scale;
  right = [force; along]./scale;
  y = matrix \ right;
  if (norm (matrix*y - right) > 1e-3*norm (right))
    y *= NaN;
  endif
  dx = [Z*y(1:end-1); y(end)];
endfunction

%!test # two masses that a constraint ties together, on a spring of 12 N/m
%! linear = struct ("K", 6, "basis", [1; 1]/sqrt (2));
%! dx = bordered (linear, [3; 0], [0; 0; 1], 0, 2);
%! assert (dx, [0.5; 0.5; 2], 1e-12);
%! assert (bordered (linear, [3; 0], [1; 0; 0], sqrt (18), 1), [1; 1; 2], 1e-12);
%!test # of a column that has just lost its stiffness only the load can change, or nothing carries the force
%! linear = struct ("K", 0, "basis", 1);
%! assert (bordered (linear, 0, [0; 1], 0, 2), [0; 2]); assert (bordered (linear, 0, [0; 1], 1, 2), [NaN; NaN]);
