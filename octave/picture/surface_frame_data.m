## -*- texinfo -*-
## @deftypefn {} {@var{text} =} surface_frame_data (@var{drawing}, @var{shown}, @var{name})
## What a picture with the @var{name} shows of a drawing with a @code{surface} (see @code{draw_surface_frames}), for
## gnuplot: the rod at the frames @var{shown}, the path of its end up to the last of them, and its ends that are held.
## @end deftypefn

function text = surface_frame_data (drawing, shown, name)
  last = shown(end);
  rod = drawing.surface.rod;
  settings = struct ("name", name, "clock", clock_text (drawing, last), "rods", numel (shown), ...
                     "elevation", 90 - drawing.surface.elevation, ...
                     "azimuth", mod (90 + drawing.surface.azimuth(last), 360));
  rods = arrayfun (@(k) [rod.x(:,k), rod.y(:,k), rod.z(:,k)], shown, "uniformoutput", false);
  behind = max (1, last - 3000):last;  # of a long run not all, since each frame draws it
  tip = [rod.x(end,behind); rod.y(end,behind); rod.z(end,behind)].';
  ends = [1, rows(rod.x)](drawing.surface.held);
  held = [rod.x(ends,last), rod.y(ends,last), rod.z(ends,last)];
  text = [gnuplot_settings(settings), gnuplot_block("rod", rods), gnuplot_block("tip", {tip([1:end, end],:)}), ...
          gnuplot_block("held", {[held; NaN(1, 3)]})];
endfunction

%!test
%! text = surface_frame_data (sample_surface (3), [1 3], "../frames/frame_0001");
%! assert (! isempty (strfind (text, "rods = 2")));
%!test # an end that is held is marked, in its place
%! drawing = sample_surface (2);
%! drawing.surface.held = [true false];
%! text = surface_frame_data (drawing, 1, "a");
%! start = sscanf (regexp (text, '\$held << END\n([^\n]*)', "tokens"){1}{1}, "%f").';
%! assert (start, [drawing.surface.rod.x(1,1), drawing.surface.rod.y(1,1), drawing.surface.rod.z(1,1)], 1e-6);
%!test # the camera, the rods at their times, and the tip's way until the last of them
%! drawing = sample_surface (4);
%! drawing.surface.elevation = 35;
%! drawing.surface.azimuth = [0 90 180 300];
%! text = surface_frame_data (drawing, [1 3], "a");
%! for line = {"name = 'a'", "elevation = 55", "azimuth = 270", ["clock = '" clock_text(drawing, 3) "'"]}
%!   assert (numel (strfind (text, [line{1} "\n"])) == 1, "%s", line{1});
%! endfor
%! assert (! isempty (strfind (surface_frame_data (drawing, 4, "a"), "azimuth = 30\n")));
%! block = @(text, name) regexp (text, ['\$' name ' << END\n(.*?)\nEND'], "tokens", "once"){1};
%! rod = drawing.surface.rod;
%! tip = [rod.x(end,1:3); rod.y(end,1:3); rod.z(end,1:3)].';
%! assert (str2num (block (text, "tip")), tip([1:3, 3],:), 1e-6);
%! rods = strsplit (block (text, "rod"), "\n\n\n");
%! assert (numel (rods), 2); assert (str2num (rods{2}), [rod.x(:,3), rod.y(:,3), rod.z(:,3)], 1e-6);
%! long = sample_surface (2);
%! for axis = "xyz"
%!   long.surface.rod.(axis) = (1:3500).*[1; 1];
%! endfor
%! long.time = (1:3500)/50;
%! long.surface.azimuth = zeros (1, 3500);
%! assert (str2num (block (surface_frame_data (long, 3400, "a"), "tip"))([1 end],1), [400; 3400]);
