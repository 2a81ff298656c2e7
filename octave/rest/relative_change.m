## -*- texinfo -*-
## @deftypefn {} {[@var{change}, @var{now}] =} relative_change (@var{now}, @var{last})
## By how much each of the numbers @var{now} (1-by-k) differs from that of the same place among the @var{last} ones, a
## part of itself or of a thousandth of the largest, whichever is more; Inf where there is none.
## @end deftypefn

function [change, now] = relative_change (now, last)
  change = Inf (size (now));
  common = 1:min (numel (now), numel (last));
  change(common) = abs (now(common) - last(common))./max (abs (now(common)), 1e-3*max (abs (now)));
endfunction

%!test
%! [change, now] = relative_change ([2 1e-3 1000 5], [1 0 999]);
%! assert (change, [0.5 1e-3 1e-3 Inf]); assert (now, [2 1e-3 1000 5]);
%!assert (relative_change ([1 2], []), [Inf Inf])
