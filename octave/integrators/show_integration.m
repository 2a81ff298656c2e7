## -*- texinfo -*-
## @deftypefn {} {} show_integration (@var{t}, @var{end_time}, @var{calls}, @var{clock})
## Show (see @code{show_progress}) how far an integration to @var{end_time} (s), begun at the @var{clock} (a tic), has
## come at the time @var{t} after so many @var{calls} (see @code{progress_text}), twice a second.
## @end deftypefn

function show_integration (t, end_time, calls, clock)
  persistent last = 0;
  seconds = toc (clock);
  if (seconds > last + 0.5 || seconds < last)
    last = seconds;
    show_progress (progress_text (t, end_time, calls, seconds));
  endif
endfunction

%!test # nothing where there is no terminal
%! assert (evalc ("show_integration (0.5, 1, 100, tic ())"), "");
