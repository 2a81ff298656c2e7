## -*- texinfo -*-
## @deftypefn {} {} watch_rate (@var{end_time})
## @deftypefnx {} {@var{y_dot} =} watch_rate (@var{t}, @var{y_dot})
## @deftypefnx {} {@var{calls} =} watch_rate ("calls")
## @deftypefnx {} {@var{calls} =} watch_rate ()
## Start to watch a rate up to @var{end_time} (s); let values pass and count them, one a column; the number of calls so
## far, a value each; end, with that number.
## On a terminal it shows how far the time @var{t} (s) has come and how many seconds are left.
## @end deftypefn

function value = watch_rate (t, value)
  persistent calls = 0 due = Inf end_time clock shown = 0;
  if (nargin == 2)
    calls += columns (value);
    if (calls >= due)
      due = calls + 1000;
      shown = show_progress (t(end), end_time, toc (clock), shown);
    endif
  elseif (nargin == 1 && ischar (t))
    value = calls;
  elseif (nargin == 1)
    [calls, end_time, clock, shown] = deal (0, t, tic (), 0);
    due = [Inf, 1000](1 + (system ("test -t 1") == 0));
  else
    value = calls;
    if (shown > 0)
      printf ("\r%60s\r", "");
    endif
  endif
endfunction

function shown = show_progress (t, end_time, seconds, shown)
  if (seconds > shown + 0.5)
    shown = seconds;
    printf ("\r%5.1f %% of %g s simulated, %.0f s left ", 100*t/end_time, end_time, seconds*(end_time/max (t, eps) - 1));
    fflush (stdout);
  endif
endfunction

%!test
%! watch_rate (1);
%! assert (watch_rate (0.5, [1; 2]), [1; 2]);
%! watch_rate (0.6, 0);
%! watch_rate ([0.7 0.8], [1 2; 3 4]);
%! assert (watch_rate (), 4);
