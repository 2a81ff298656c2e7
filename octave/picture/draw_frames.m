## -*- texinfo -*-
## @deftypefn {} {@var{jobs} =} draw_frames (@var{drawing}, @var{scratch})
## The frames of @var{drawing} (see @code{draw_pictures}) in the folder @file{frames} beside the
## folder @var{scratch}, which takes the data. They are there when all @var{jobs} (see @code{finish_tool}) have ended:
## shares of the frames, each of which is drawn while the data of the next one are written.
## @end deftypefn

function jobs = draw_frames (drawing, scratch)
  mkdir (fullfile (scratch, "..", "frames"));
  frame_size = [1280 720];
  if (isfield (drawing, "frame_size"))
    frame_size = drawing.frame_size(:).';
  endif
  ## Everything is laid out for 1280 by 720, in units of as many pixels as let that fit in.
  scale = min (frame_size ./ [1280 720]);
  camera = fit_camera (drawing, frame_size/scale - [610 130]);
  [stress, range, unit] = body_stress (drawing.bodies);
  settings = scene_settings (drawing, camera);
  slowed = drawing.frames_per_second/film_rate (drawing.frames_per_second);
  if (slowed > 1)
    settings.zoom = sprintf ("slowed × %.3g, %s", slowed, settings.zoom);
  endif
  [settings.unit, settings.width, settings.height] = deal (scale, frame_size(1), frame_size(2));
  settings.stress = range;
  settings.stress_label = ["largest bending stress, " unit];
  coloured = ! cellfun (@isempty, stress);
  settings.coloured = sum (coloured);
  settings.thickness = sprintf ("%.2f ", 2 * max ([drawing.bodies(coloured).half_height] / camera.pixel, 1.5));
  settings.t = padded_range (drawing.time);
  settings.t_step = tic_step (settings.t, 6);
  if (numel (sprintf ("%g", settings.t_step)) > 4)
    settings.t_step = tic_step (settings.t, 4);
  endif
  write_text (fullfile (scratch, "settings.gp"), [gnuplot_settings(settings), strip_data(drawing)]);

  frames = numel (drawing.time);
  shares = min (2*nproc (), frames);
  for share = 1:shares
    mine = floor ((share - 1)*frames/shares) + 1:floor (share*frames/shares);
    for frame = mine
      write_text (fullfile (scratch, sprintf ("%04d.gp", frame)), frame_data (drawing, stress, camera, frame));
    endfor
    jobs(share) = start_gnuplot (scratch, "frames.gp", mine(1), mine(end));
  endfor
endfunction

## $history: the time and all curves of the strips; and what each strip has, as lists of words
function text = strip_data (drawing)
  settings = struct ("strips", numel (drawing.strips), "labels", "", "names", "", "named", "", "curves", "", ...
                     "low", "", "high", "", "step", "");
  table = drawing.time;
  for i = 1:settings.strips
    [label, values] = scaled_panel (drawing.strips(i));
    range = padded_range (values);
    settings.labels = [settings.labels, "\"", label, "\" "];
    settings.curves = [settings.curves, sprintf("%d ", rows (values))];
    settings.low = [settings.low, sprintf("%.9g ", range(1))];
    settings.high = [settings.high, sprintf("%.9g ", range(2))];
    settings.step = [settings.step, sprintf("%.9g ", tic_step (range, 4))];
    ## As many names as there is room for, beside the label, in 295 units.
    columns_left = (285 - 8.5*numel (label))/(8.5*max (cellfun (@numel, drawing.strips(i).names)) + 36);
    settings.named = [settings.named, sprintf("%d ", max (0, floor (columns_left)))];
    settings.names = [settings.names, sprintf("\"%s\" ", drawing.strips(i).names{:})];
    table = [table; values];
  endfor
  text = [gnuplot_settings(settings), gnuplot_block("history", {table.'})];
endfunction

%!function sizes_are_right (drawing, pixels)
%!  folder = tempname ();
%!  mkdir (folder);
%!  mkdir (fullfile (folder, "scratch"));
%!  unwind_protect
%!    arrayfun (@finish_tool, draw_frames (drawing, fullfile (folder, "scratch")));
%!    for frame = 1:numel (drawing.time)
%!      information = imfinfo (fullfile (folder, "frames", sprintf ("frame_%04d.png", frame)));
%!      assert ([information.Width, information.Height], pixels);
%!    endfor
%!  unwind_protect_cleanup
%!    confirm_recursive_rmdir (false, "local");
%!    rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!test # more frames than processors
%! sizes_are_right (sample_drawing (5), [1280 720]);
%!test # bodies that are pinned together, and bodies that are free, with nothing beside them
%! sizes_are_right (sample_bodies (2), [1280 720]);
%! drawing = sample_bodies (1);
%! drawing.hinges = struct ("x", zeros (0, 1), "y", zeros (0, 1));
%! drawing.strips = [];
%! drawing.frame_size = [400 600];
%! sizes_are_right (drawing, [400 600]);
