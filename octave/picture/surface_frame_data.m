## -*- texinfo -*-
## @deftypefn {} {@var{text} =} surface_frame_data (@var{drawing}, @var{shown}, @var{name})
## What a picture with the @var{name} shows of a drawing with a @code{surface} (see @code{draw_surface_frames}), for
## gnuplot: the rod at the frames @var{shown}, and the path of its end up to the last of them.
## @end deftypefn

function text = surface_frame_data (drawing, shown, name)
  last = shown(end);
  rod = drawing.surface.rod;
  settings = struct ("name", name, "clock", clock_text (drawing, last), "rods", numel (shown), ...
                     "elevation", 90 - drawing.surface.elevation, "azimuth", mod (90 + drawing.surface.azimuth(last), 360));
  rods = arrayfun (@(k) [rod.x(:,k), rod.y(:,k), rod.z(:,k)], shown, "uniformoutput", false);
  tip = [rod.x(end,1:last); rod.y(end,1:last); rod.z(end,1:last)].';
  text = [gnuplot_settings(settings), gnuplot_block("rod", rods), gnuplot_block("tip", {tip([1:end, end],:)})];
endfunction

%!test
%! text = surface_frame_data (sample_surface (3), [1 3], "../frames/frame_0001");
%! assert (! isempty (strfind (text, "rods = 2")));
