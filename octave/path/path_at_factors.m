## -*- texinfo -*-
## @deftypefn {} {[@var{points}, @var{shares}] =} path_at_factors (@var{path}, @var{point}, @var{next}, @var{factors})
## The points of a @var{path} (see @code{path_point}; a cell array) at each of the @var{factors} that it passes between
## a @var{point} and the @var{next} one, and the @var{shares} of the way there (see @code{path_cubic}), from near to
## far.
## @end deftypefn

function [points, shares] = path_at_factors (path, point, next, factors)
  cubic = path_cubic (point, next);
  points = {};
  shares = [];
  fixed = (1:rows (cubic)).' == rows (cubic);
  for factor = factors(:).'
    passed = roots (cubic(end,:) - [0 0 0 factor]);
    for share = real (passed(abs (imag (passed)) < 1e-12 & real (passed) > 0 & real (passed) < 1)).'
      x = [(cubic*[share^3; share^2; share; 1])(1:end-1); factor];
      found = path_point (path, x, point.lambda + share*(next.lambda - point.lambda), fixed);
      if (! isempty (found) && min (abs (factor - [point.x(end), next.x(end)])) > 1e-9*path.range)
        found.tangent = path_tangent (found, next.tangent);
        points{end+1} = found;
        shares(end+1) = share;
      endif
    endfor
  endfor
  [shares, order] = sort (shares);
  points = points(order);
endfunction

%!test # of a column that leans, between two points at which sin (q) = (q - lean)/factor
%! path = sprung_column (0.1);
%! at = @(q) path_point (path, [q; (q - 0.1)/sin(q)], zeros (0, 1), [1; 0]);
%! [point, next] = deal (at (0.15), at (0.25));
%! [point.tangent, next.tangent] = deal (path_tangent (point, [1; 0]), path_tangent (next, [1; 0]));
%! [points, shares] = path_at_factors (path, point, next, [0.2 0.4 0.5 0.7 next.x(2)]);
%! assert (cellfun (@(point) point.x(2), points), [0.4 0.5]);
%! q = cellfun (@(point) point.x(1), points);
%! assert (q - 0.1, [0.4 0.5].*sin (q), 1e-12); assert (0.15 + 0.1*shares, q, 0.01);
%! [points, shares] = path_at_factors (path, point, next, [0.5 0.4]);  # from near to far, however they are asked for
%! assert (cellfun (@(point) point.x(2), points), [0.4 0.5]); assert (issorted (shares));
%! points = path_at_factors (setfield (path, "range", 1e-8), point, next, 0.4);  # which may be small against 1
%! assert (numel (points), 1);
