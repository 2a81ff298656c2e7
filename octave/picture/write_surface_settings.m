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
%!assert (! isempty (strfind (in_scratch (@(folder, scratch) settings_in (scratch)), "kinds = 'png'")))
