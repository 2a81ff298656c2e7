## -*- texinfo -*-
## @deftypefn {} {@var{time} =} panel_time (@var{drawing})
## The times (1-by-m, s) of the panels of a @var{drawing} (see @code{draw_pictures}): those of the frames, or its own.
## @end deftypefn

function time = panel_time (drawing)
  time = field_or (drawing, "panel_time", drawing.time);
endfunction

%!assert (panel_time (struct ("time", [0 1])), [0 1])
%!assert (panel_time (struct ("time", [0 1], "panel_time", [0 0.5 1])), [0 0.5 1])
