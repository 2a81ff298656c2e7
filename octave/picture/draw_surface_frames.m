## -*- texinfo -*-
## @deftypefn {} {@var{jobs} =} draw_surface_frames (@var{drawing}, @var{scratch})
## As @code{draw_frames}, of a drawing with a @code{surface}: a struct of the @code{patch} (see @code{surface_patch})
## and the @code{rod} (a struct of x, y, z, P-by-F, m), with the @code{room} (m) that both have around them, whether
## the rod's two ends are @code{held}, the camera's @code{elevation} (degrees) and its @code{azimuth} in each frame.
## What lies behind the surface is hidden.
## @end deftypefn

function jobs = draw_surface_frames (drawing, scratch)
  mkdir (fullfile (scratch, "..", "frames"));
  write_surface_settings (drawing, scratch, "png");
  frames = numel (drawing.time);
  name = @(frame) fullfile ("..", frame_names (frame, frames){1}(1:end-4));  # without .png
  jobs = start_shares (scratch, "surface.gp", frames, @(frame, ~) surface_frame_data (drawing, frame, name (frame)));
endfunction

%!function check_size (folder, scratch)
%!  arrayfun (@finish_tool, draw_surface_frames (setfield (sample_surface (2), "frame_size", [640 400]), scratch));
%!  information = imfinfo (fullfile (folder, "frames", "frame_0002.png"));
%!  assert ([information.Width, information.Height], [640 400]);
%!endfunction
%!test in_scratch (@check_size); # frames of the right size
