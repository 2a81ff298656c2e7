## -*- texinfo -*-
## @deftypefn {} {[@var{arrow}, @var{label}] =} moment_arrow (@var{moment}, @var{centre}, @var{direction}, @
##   @var{radius})
## The polyline (n-by-2, m) of an arc arrow around @var{centre} (1-by-2, m) in the sense of @var{moment} (N m) with
## its middle at the angle @var{direction} (rad), and the place (1-by-2, m) of its @var{label}.
## @end deftypefn

function [arrow, label] = moment_arrow (moment, centre, direction, radius)
  angle = direction + sign (moment) * linspace (-1, 1, 40).';
  ring = @(angle, factor) centre + radius * factor .* [cos(angle), sin(angle)];
  barbs = angle(end) - sign (moment) * 0.3;
  arrow = [ring(angle, 1); NaN(1, 2); ring(barbs, 1.16); ring(angle(end), 1); ring(barbs, 0.88)];
  label = ring (direction, 1.35);
endfunction

%!test # a positive moment turns counterclockwise
%! arrow = moment_arrow (5, [1 2], 0, 0.1);
%! assert (arrow(1,2) < 2 && arrow(40,2) > 2);
%! assert (hypot (arrow(1:40,1) - 1, arrow(1:40,2) - 2), 0.1 * ones (40, 1), 1e-12);
%!test # from a radian before the direction to one behind it, the barbs near its end, and its value beyond it
%! for sense = [1 -1]
%!   [arrow, label] = moment_arrow (5*sense, [0 0], pi/2, 2);
%!   assert (size (arrow), [44 2]);
%!   angles = atan2 (arrow(:,2), arrow(:,1));
%!   assert (angles([1 40 43]).', pi/2 + sense*[-1 1 1], 1e-12);
%!   assert (angles([42 44]).', pi/2 + sense*[0.7 0.7], 1e-12);
%!   assert (hypot (arrow([42 43 44],1), arrow([42 43 44],2)).', 2*[1.16 1 0.88], 1e-12);
%!   assert (label, [0 2.7], 1e-12);
%! endfor
