## -*- texinfo -*-
## @deftypefn {} {@var{rate} =} film_rate (@var{frames_per_second})
## How many frames a second the film shows: those of the motion, but 50 where it has more than 60, which no screen
## shows: such a film is in slow motion.
## @end deftypefn

function rate = film_rate (frames_per_second)
  rate = frames_per_second;
  if (rate > 60)
    rate = 50;
  endif
endfunction

%!assert (film_rate (24), 24)
%!assert (film_rate (10000), 50)
%!assert (arrayfun (@film_rate, [60 61]), [60 50])
