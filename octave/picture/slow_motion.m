## -*- texinfo -*-
## @deftypefn {} {@var{text} =} slow_motion (@var{drawing})
## How much slower than the motion the film of @var{drawing} is (see @code{film_rate}), in words; "" where it is not.
## @end deftypefn

function text = slow_motion (drawing)
  slowed = drawing.frames_per_second/film_rate (drawing.frames_per_second);
  text = "";
  if (slowed > 1)
    text = sprintf ("slowed × %.3g", slowed);
  endif
endfunction

%!assert (slow_motion (struct ("frames_per_second", 50)), "")
%!assert (slow_motion (struct ("frames_per_second", 1000)), "slowed × 20")
