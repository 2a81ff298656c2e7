## -*- texinfo -*-
## @deftypefn {} {@var{text} =} clock_text (@var{drawing}, @var{frame})
## The time of a @var{frame} of @var{drawing} (see @code{draw_pictures}), as fine as its frames, in the unit of its axes
## (see @code{axis_unit}).
## @end deftypefn

function text = clock_text (drawing, frame)
  [scale, unit] = axis_unit (drawing.time([1 end]), "s");
  decimals = max (2*(scale == 1), ceil (log10 (drawing.frames_per_second*scale)));
  text = sprintf ("t = %.*f %s", decimals, drawing.time(frame)/scale, unit);
endfunction

%!assert (clock_text (struct ("frames_per_second", 1000, "time", [0 0.1]), 2), "t = 0.100 s")
%!assert (clock_text (struct ("frames_per_second", 5e5, "time", [0 6e-5 1e-4]), 2), "t = 60 µs")
