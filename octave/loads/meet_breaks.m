## -*- texinfo -*-
## @deftypefn {} {[@var{times}, @var{ends}] =} meet_breaks (@var{times}, @var{breaks})
## The @var{times} (1-by-m, s) of an integration, where one that is a break up to rounding is that break, and the
## @var{ends} of the intervals that it takes for themselves: the first time, the @var{breaks} inside, the last time.
## @end deftypefn

function [times, ends] = meet_breaks (times, breaks)
  for t = breaks
    times(abs (times - t) <= 1e-12*times(end)) = t;
  endfor
  ends = unique ([times(1), breaks(breaks > times(1) & breaks < times(end)), times(end)]);
endfunction

%!test
%! [times, ends] = meet_breaks ([0 12.3 20], 12.3 + [0 1e-14 1 9]);
%! assert (times(2), 12.3 + 1e-14); assert (ends(end), 20); assert (ends(1), 0);
%!assert (nthargout (2, @meet_breaks, [0 1], [0.3 0.5 1 2]), [0 0.3 0.5 1])
%!assert (nthargout (2, @meet_breaks, 0, [0.3 0.5]), 0)
