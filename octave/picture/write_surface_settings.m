## -*- texinfo -*-
## @deftypefn {} {} write_surface_settings (@var{drawing}, @var{scratch}, @var{kinds})
## What @file{surface.gp} needs for all frames, in the folder @var{scratch}: @var{kinds} are the kinds of files, as
## words.
## @end deftypefn

function write_surface_settings (drawing, scratch, kinds)
  patch = drawing.surface.patch;
  settings = struct ("title", drawing.title, "title_size", min (20, 1300/numel (drawing.title)), "kinds", kinds, ...
                     "slow", slow_motion (drawing));
  [springs, forces] = lines_in_space (drawing.surface);
  for axis = "xyz"
    values = [patch.(axis)(:); springs.(["to_" axis])(:); forces.(axis)(:)];
    settings.(axis) = [min(values), max(values)] + [-1, 1]*drawing.surface.room;
    points.(axis) = values - mean (settings.(axis));
  endfor
  [settings.half_width, settings.half_height] = halves_of_view (points, drawing.surface);
  lines = arrayfun (@(k) [patch.x(:,k), patch.y(:,k), patch.z(:,k), patch.shade(:,k); NaN(1, 4)], ...
                    1:columns (patch.x), "uniformoutput", false);
  write_text (fullfile (scratch, "settings.gp"), ...
              [gnuplot_settings(settings), gnuplot_settings(frame_layout (drawing)), ...
               gnuplot_block("surface", {vertcat(lines{:})}), strip_data(drawing)]);
endfunction

## how far the points are off the middle of the picture, at any azimuth, m
function [wide, high] = halves_of_view (points, surface)
  wide = high = 0;
  for azimuth = unique (mod (surface.azimuth, 360))
    [x, y] = seen (points, struct ("elevation", surface.elevation, "azimuth", azimuth));
    wide = max (wide, max (abs (x)));
    high = max (high, max (abs (y)));
  endfor
endfunction

%!function text = settings_in (scratch, drawing)
%!  write_surface_settings (drawing, scratch, "png");
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # the patch, an empty line after each column of its nine, within the room around it
%! text = in_scratch (@(folder, scratch) settings_in (scratch, sample_surface (2)));
%! assert (! isempty (strfind (text, "kinds = 'png'")));
%! for range = {"x_low = -2.1", "x_high = 2.1", "y_low = -2.1", "y_high = 2.1", "z_low = -0.1", "z_high = 0.1"}
%!   assert (numel (strfind (text, ["\n" range{1} "\n"])), 1);
%! endfor
%! columns = strsplit (strtrim (regexp (text, '\$surface << END\n(.*?)\nEND', "tokens", "once"){1}), "\n\n");
%! assert (numel (columns), 9);
%! assert (str2num (columns{9}), [2*ones(9, 1), (-2:0.5:2).', zeros(9, 1), 0.5*ones(9, 1)]);
%!test # what the camera sees at any azimuth, with the place of a spring above the plane
%! drawing = sample_surface (2);
%! drawing.surface.azimuth = [0 45];
%! drawing.surface.springs = struct ("x", 0, "y", 0, "z", 0, "to_x", 0, "to_y", 0, "to_z", 3.9);
%! text = in_scratch (@(folder, scratch) settings_in (scratch, drawing));
%! half = @(name) str2double (regexp (text, ["half_" name ' = (\S+)'], "tokens", "once"){1});
%! assert (half ("width"), 2*sqrt (2), 1e-5);
%! assert (half ("height"), 1.95*cosd (40) + 2*sqrt (2)*sind (40), 1e-5);
