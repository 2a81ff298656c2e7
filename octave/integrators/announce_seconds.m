## -*- texinfo -*-
## @deftypefn {} {@var{told} =} announce_seconds (@var{told}, @var{t}, @var{end_time}, @var{seconds})
## Say, where there is no terminal that shows it, how long an integration to @var{end_time} (s) will take that has come
## to the time @var{t} in so many @var{seconds}: after five of them, where it is more than half a minute, and again
## after another half a minute or more, where it is twice as long by then.  @var{told} is what was foreseen when that
## was last decided, and after how many seconds, [] before that.
## @end deftypefn

function told = announce_seconds (told, t, end_time, seconds)
  if (seconds < 5 || t <= 0)
    return;
  endif
  whole = seconds*end_time/t;
  if (! isempty (told) && (whole < 2*told(1) || seconds < told(2) + 30))
    return;
  endif
  told = [whole, seconds];
  if (whole > 30)
    say ("  this integration will take about %.0f s: %.3g of %g s are simulated after %.0f s", whole, t, end_time, seconds);
  endif
endfunction

%!function [said, told] = of (varargin)
%!  said = evalc ("told = announce_seconds (varargin{:});");
%!endfunction
%!test
%! [said, told] = of ([], 0.5, 10, 6);
%! assert (said, "  this integration will take about 120 s: 0.5 of 10 s are simulated after 6 s\n");
%! assert (told, [120 6]);
%! assert (nthargout (1:2, @of, [], 5, 10, 6), {"", [12 6]});
%! assert (nthargout (1:2, @of, [], 0.5, 10, 4.9), {"", []});
%! assert (nthargout (1:2, @of, [], 0, 10, 6), {"", []});
%! assert (nthargout (1:2, @of, [120 6], 0.5, 10, 6), {"", [120 6]});
%!test # what looked short, and what has become twice as long, half a minute later
%! said = "  this integration will take about 37 s: 9.72 of 10 s are simulated after 36 s\n";
%! assert (nthargout (1:2, @of, [12 6], 9.72, 10, 36), {said, [36/0.972, 36]});
%! assert (nthargout (1:2, @of, [12 6], 5, 10, 35.9), {"", [12 6]});
%! assert (nthargout (1:2, @of, [120 6], 2, 10, 47.9), {"", [120 6]});
%! said = "  this integration will take about 240 s: 2 of 10 s are simulated after 48 s\n";
%! assert (nthargout (1:2, @of, [120 6], 2, 10, 48), {said, [240 48]});
