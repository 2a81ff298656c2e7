## -*- texinfo -*-
## @deftypefn {} {@var{text} =} progress_text (@var{t}, @var{end_time}, @var{calls}, @var{seconds})
## How far an integration to @var{end_time} (s) has come at the time @var{t}, after so many @var{calls} and
## @var{seconds}, and how many seconds are left if it goes on like that.
## @end deftypefn

function text = progress_text (t, end_time, calls, seconds)
  left = "";
  if (t > 0)
    left = sprintf (", %.0f s left", seconds*(end_time/t - 1));
  endif
  text = sprintf ("%.4g of %g s simulated, %d calls%s ", t, end_time, calls, left);
endfunction

%!assert (progress_text (0.5, 2, 60, 4), "0.5 of 2 s simulated, 60 calls, 12 s left ")
%!assert (progress_text (0, 2, 60, 4), "0 of 2 s simulated, 60 calls ")
