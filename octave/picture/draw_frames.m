## -*- texinfo -*-
## @deftypefn {} {} draw_frames (@var{drawing}, @var{scratch})
## The frames of @var{drawing} (see @code{draw_pictures}), 1280 by 720 pixels, in the folder @file{frames} beside the
## folder @var{scratch}, which takes the data.
## @end deftypefn

function draw_frames (drawing, scratch)
  mkdir (fullfile (scratch, "..", "frames"));
  camera = fit_camera (drawing, [670 590]);
  [stress, range, unit] = body_stress (drawing.bodies);
  history = [drawing.time; rad2deg(drawing.history.phi); drawing.history.phi_dot; drawing.moment];

  settings = scene_settings (drawing, camera);
  settings.stress = range;
  settings.stress_label = ["largest bending stress, " unit];
  coloured = ! cellfun (@isempty, stress);
  settings.coloured = sum (coloured);
  settings.thickness = sprintf ("%.2f ", 2 * max ([drawing.bodies(coloured).half_height] / camera.pixel, 1.5));
  names = {"t", "phi", "phi_dot", "moment"};
  for i = 1:4
    settings.(names{i}) = padded_range (history(i,:));
    settings.([names{i} "_step"]) = tic_step (settings.(names{i}), 6 - 2*(i > 1));
  endfor
  write_text (fullfile (scratch, "settings.gp"),
              [gnuplot_settings(settings), gnuplot_block("history", {history.'})]);

  frames = numel (drawing.time);
  for frame = 1:frames
    write_text (fullfile (scratch, sprintf ("%04d.gp", frame)), frame_data (drawing, stress, camera, frame));
  endfor
  run_gnuplot (scratch, "frames.gp", frames);
endfunction

%!test # more frames than processors, each with the right size
%! folder = tempname ();
%! mkdir (folder);
%! mkdir (fullfile (folder, "scratch"));
%! unwind_protect
%!   draw_frames (sample_drawing (5), fullfile (folder, "scratch"));
%!   for frame = 1:5
%!     information = imfinfo (fullfile (folder, "frames", sprintf ("frame_%04d.png", frame)));
%!     assert ([information.Width, information.Height], [1280, 720]);
%!   endfor
%! unwind_protect_cleanup
%!   confirm_recursive_rmdir (false, "local");
%!   rmdir (folder, "s");
%! end_unwind_protect
