## -*- texinfo -*-
## @deftypefn {} {@var{jobs} =} draw_frames (@var{drawing}, @var{scratch})
## The frames of @var{drawing} (see @code{draw_pictures}) in the folder @file{frames} beside the
## folder @var{scratch}, which takes the data. They are there when all @var{jobs} have ended (see @code{start_shares}).
## @end deftypefn

function jobs = draw_frames (drawing, scratch)
  mkdir (fullfile (scratch, "..", "frames"));
  layout = frame_layout (drawing);
  room = [95 + layout.scene_right, layout.scene_bottom + layout.scene_top];
  camera = fit_camera (drawing, [layout.width, layout.height]/layout.unit - room);
  [stress, range, unit] = body_stress (drawing.bodies);
  settings = scene_settings (drawing, camera);
  slowed = slow_motion (drawing);
  if (! isempty (slowed))
    settings.zoom = [slowed ", " settings.zoom];
  endif
  [~, settings.frame_name] = frame_names ([], numel (drawing.time));
  settings.stress = range;
  settings.stress_unit = unit;
  coloured = ! cellfun (@isempty, stress);
  settings.coloured = sum (coloured);
  settings.thickness = num2cell (2*max ([drawing.bodies(coloured).half_height]/camera.pixel, 1.5));
  [path, pieces] = tip_path (drawing.bodies);
  write_text (fullfile (scratch, "settings.gp"), ...
              [gnuplot_settings(settings), gnuplot_settings(layout), strip_data(drawing)]);
  data = @(frame, tip) frame_data (drawing, stress, camera, frame, tip);
  jobs = start_shares (scratch, "frames.gp", numel (drawing.time), ...
                       @(frame, first) with_path (data, frame, first, path, pieces));
endfunction

%!function check_sizes (drawing, pixels, folder, scratch)
%!  arrayfun (@finish_tool, draw_frames (drawing, scratch));
%!  for frame = 1:numel (drawing.time)
%!    information = imfinfo (fullfile (folder, "frames", sprintf ("frame_%04d.png", frame)));
%!    assert ([information.Width, information.Height], pixels);
%!  endfor
%!endfunction
%!test # more frames than processors
%! in_scratch (@(folder, scratch) check_sizes (sample_drawing (5), [1280 720], folder, scratch));
%!test # bodies that are pinned together, and bodies that are free, with nothing beside them
%! in_scratch (@(folder, scratch) check_sizes (sample_bodies (2), [1280 720], folder, scratch));
%! drawing = sample_bodies (1);
%! drawing.hinges = struct ("x", zeros (0, 1), "y", zeros (0, 1));
%! drawing.strips = [];
%! drawing.frame_size = [400 600];
%! in_scratch (@(folder, scratch) check_sizes (drawing, [400 600], folder, scratch));
