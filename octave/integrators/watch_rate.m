## -*- texinfo -*-
## @deftypefn {} {} watch_rate ("start", @var{end_time})
## @deftypefnx {} {@var{y_dot} =} watch_rate (@var{t}, @var{y_dot})
## @deftypefnx {} {@var{calls} =} watch_rate ("stop")
## Count the calls of a rate between start and stop and, on a terminal, show how far the time @var{t} (s) has come.
## The rate passes through.
## @end deftypefn

function value = watch_rate (t, value)
  persistent calls end_time clock shown on_terminal;
  if (! ischar (t))
    if (! bitand (++calls, 1023) && on_terminal && toc (clock) > shown + 0.5)
      shown = toc (clock);
      printf ("\r%5.1f %% of %g s simulated, %.0f s left ", 100*t/end_time, end_time, shown*(end_time/max (t, eps) - 1));
      fflush (stdout);
    endif
  elseif (strcmp (t, "start"))
    [calls, end_time, clock, shown] = deal (0, value, tic (), 0);
    on_terminal = system ("test -t 1") == 0;
  else
    value = calls;
    if (shown > 0)
      printf ("\r%60s\r", "");
    endif
  endif
endfunction

%!test
%! watch_rate ("start", 1);
%! assert (watch_rate (0.5, [1; 2]), [1; 2]);
%! watch_rate (0.6, 0);
%! assert (watch_rate ("stop"), 2);
