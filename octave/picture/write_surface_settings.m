## -*- texinfo -*-
## @deftypefn {} {} write_surface_settings (@var{drawing}, @var{scratch}, @var{kinds})
## What @file{surface.gp} needs for all frames, in the folder @var{scratch}: @var{kinds} are the kinds of files, as
## words.
## @end deftypefn

function write_surface_settings (drawing, scratch, kinds)
  patch = drawing.surface.patch;
  settings = struct ("title", drawing.title, "title_size", min (20, 1300/numel (drawing.title)), "kinds", kinds, ...
                     "slow", slow_motion (drawing));
  for axis = "xyz"
    values = patch.(axis)(:);
    settings.(axis) = [min(values), max(values)] + [-1, 1]*drawing.surface.room;
  endfor
  lines = arrayfun (@(k) [patch.x(:,k), patch.y(:,k), patch.z(:,k), patch.shade(:,k); NaN(1, 4)], ...
                    1:columns (patch.x), "uniformoutput", false);
  write_text (fullfile (scratch, "settings.gp"), ...
              [gnuplot_settings(settings), gnuplot_settings(frame_layout (drawing)), ...
               gnuplot_block("surface", {vertcat(lines{:})}), strip_data(drawing)]);
endfunction

%!function text = settings_in (scratch)
%!  write_surface_settings (sample_surface (2), scratch, "png");
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # the patch, an empty line after each column of its nine, within the room around it
%! text = in_scratch (@(folder, scratch) settings_in (scratch));
%! assert (! isempty (strfind (text, "kinds = 'png'")));
%! for range = {"x_low = -2.1", "x_high = 2.1", "y_low = -2.1", "y_high = 2.1", "z_low = -0.1", "z_high = 0.1"}
%!   assert (numel (strfind (text, ["\n" range{1} "\n"])), 1);
%! endfor
%! columns = strsplit (strtrim (regexp (text, '\$surface << END\n(.*?)\nEND', "tokens", "once"){1}), "\n\n");
%! assert (numel (columns), 9);
%! assert (str2num (columns{9}), [2*ones(9, 1), (-2:0.5:2).', zeros(9, 1), 0.5*ones(9, 1)]);
