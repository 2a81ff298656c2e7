## -*- texinfo -*-
## @deftypefn {} {[@var{rest}, @var{back}, @var{ahead}] =} pushed_lines (@var{balance}, @var{q}, @var{step})
## The centrelines of a @var{balance} (see @code{mechanism_at_rest}) with coordinates @var{q}, and the same moved
## against and along a @var{step} (n-by-1) by an eighth of their extent: cell arrays of places, a body each.
## @end deftypefn

function [rest, back, ahead] = pushed_lines (balance, q, step)
  rest = balance.shape (q);
  extent = max ([range(vertcat (rest{:})), 1e-3*balance.length]);
  step *= 1e-4*balance.length/balance.size (step);
  way = cellfun (@minus, balance.shape (q + step), balance.shape (q - step), "uniformoutput", false);
  large = extent/8/max (norm (vertcat (way{:}), "rows"));
  moved = @(sign) cellfun (@(places, one) places + sign*large*one, rest, way, "uniformoutput", false);
  back = moved (-1);
  ahead = moved (1);
endfunction

%!test # a rod of 2 m along x that turns about its start
%! balance = struct ("length", 2, "size", @(step) 2*abs (step), "shape", @(q) {[0 0; 2*cos(q) 2*sin(q)]});
%! [rest, back, ahead] = pushed_lines (balance, 0, 3);
%! assert ([rest{1}; back{1}; ahead{1}], [0 0; 2 0; 0 0; 2 -0.25; 0 0; 2 0.25], 1e-12);
