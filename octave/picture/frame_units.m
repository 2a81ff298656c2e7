## -*- texinfo -*-
## @deftypefn {} {[@var{frame_size}, @var{unit}] =} frame_units (@var{drawing})
## Width and height of the frames of @var{drawing} in pixels (see @code{draw_pictures}), and the @var{unit} of what is
## laid out for 1280 by 720: as many pixels as let that fit in.
## @end deftypefn

function [frame_size, unit] = frame_units (drawing)
  frame_size = [1280 720];
  if (isfield (drawing, "frame_size"))
    frame_size = drawing.frame_size(:).';
  endif
  unit = min (frame_size ./ [1280 720]);
endfunction

%!test
%! [frame_size, unit] = frame_units (struct ("frame_size", [640; 720]));
%! assert (frame_size, [640 720]); assert (unit, 0.5);
%!assert (frame_units (struct ()), [1280 720])
