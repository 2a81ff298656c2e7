## -*- texinfo -*-
## @deftypefn {} {} watch_rate (@var{end_time})
## @deftypefnx {} {@var{y_dot} =} watch_rate (@var{t}, @var{y_dot})
## @deftypefnx {} {} watch_rate ("steps", @var{steps})
## @deftypefnx {} {@var{calls} =} watch_rate ("calls")
## @deftypefnx {} {@var{calls} =} watch_rate ()
## Start to watch a rate up to @var{end_time} (s); let values pass and count them, one a column; be told of so many
## more @var{steps}; the number of calls so far, a value each; end, with that number.  On a terminal it shows how far
## the time @var{t} (s) has come (see @code{progress_text}).
## @end deftypefn

function value = watch_rate (t, value)
  persistent calls = 0 steps = 0 due = Inf end_time clock shown = 0;
  if (nargin == 2 && ischar (t))
    steps += value;
  elseif (nargin == 2)
    calls += columns (value);
    if (calls >= due)
      due = calls + 50;
      seconds = toc (clock);
      if (seconds > shown + 0.5)
        shown = seconds;
        show_progress (progress_text (t(end), end_time, steps, calls, seconds));
      endif
    endif
  elseif (nargin == 1 && ischar (t))
    value = calls;
  elseif (nargin == 1)
    [calls, steps, end_time, clock, shown] = deal (0, 0, t, tic (), 0);
    due = [Inf, 50](1 + on_terminal ());
  else
    value = calls;
    show_progress ("");
  endif
endfunction

%!test
%! watch_rate (1);
%! assert (watch_rate (0.5, [1; 2]), [1; 2]);
%! watch_rate (0.6, 0);
%! watch_rate ("steps", 7);
%! watch_rate ([0.7 0.8], [1 2; 3 4]);
%! assert (watch_rate (), 4);
