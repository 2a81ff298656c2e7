## -*- texinfo -*-
## @deftypefn {} {@var{text} =} clock_text (@var{drawing}, @var{frame})
## The time of a @var{frame} of @var{drawing} (see @code{draw_pictures}), as fine as its frames.
## @end deftypefn

function text = clock_text (drawing, frame)
  text = sprintf ("t = %.*f s", max (2, ceil (log10 (drawing.frames_per_second))), drawing.time(frame));
endfunction

%!assert (clock_text (struct ("frames_per_second", 1000, "time", [0 0.1]), 2), "t = 0.100 s")
