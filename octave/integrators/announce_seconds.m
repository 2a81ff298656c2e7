## -*- texinfo -*-
## @deftypefn {} {@var{told} =} announce_seconds (@var{told}, @var{t}, @var{end_time}, @var{seconds})
## Say once, where there is no terminal that shows it, how long an integration to @var{end_time} (s) will take that has
## come to the time @var{t} in so many @var{seconds}: after five of them, where it is more than half a minute.
## @var{told} is whether that has been decided.
## @end deftypefn

function told = announce_seconds (told, t, end_time, seconds)
  if (told || seconds < 5 || t <= 0)
    return;
  endif
  told = true;
  whole = seconds*end_time/t;
  if (whole > 30)
    say ("  this integration will take about %.0f s: %.3g of %g s are simulated after %.0f s", whole, t, end_time, seconds);
  endif
endfunction

%!function [said, told] = of (varargin)
%!  said = evalc ("told = announce_seconds (varargin{:});");
%!endfunction
%!test
%! [said, told] = of (false, 0.5, 10, 6);
%! assert (said, "  this integration will take about 120 s: 0.5 of 10 s are simulated after 6 s\n"); assert (told);
%! assert (nthargout (1:2, @of, false, 5, 10, 6), {"", true});
%! assert (nthargout (1:2, @of, false, 0.5, 10, 4.9), {"", false});
%! assert (nthargout (1:2, @of, false, 0, 10, 6), {"", false});
%! assert (nthargout (1:2, @of, true, 0.5, 10, 6), {"", true});
