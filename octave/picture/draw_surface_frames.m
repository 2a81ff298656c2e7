## -*- texinfo -*-
## @deftypefn {} {@var{jobs} =} draw_surface_frames (@var{drawing}, @var{scratch})
## As @code{draw_frames}, of a drawing with a @code{surface}: a struct of the @code{patch} (see @code{surface_patch})
## and the @code{rod} (a struct of x, y, z, P-by-F, m), with the @code{room} (m) that both have around them, whether
## the rod's two ends are @code{held}, the camera's @code{elevation} (degrees) and its @code{azimuth} in each frame, and
## where there are some @code{springs} and @code{forces} (see @code{acting_in_space}).
## What lies behind the surface is hidden, but for a thin dashed line of the rod.
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
%!function red = redness (folder, scratch, drawing)   # how many points of its first frame are red
%!  arrayfun (@finish_tool, draw_surface_frames (drawing, scratch));
%!  picture = double (imread (fullfile (folder, "frames", "frame_0001.png")));
%!  red = nnz (picture(:,:,1) > picture(:,:,3) + 40);
%!endfunction
%!test # a rod below the plane is dashed
%! drawing = setfield (sample_surface (1), "frame_size", [1280 720]);
%! above = in_scratch (@(folder, scratch) redness (folder, scratch, drawing));
%! drawing.surface.rod.z -= 0.1;
%! below = in_scratch (@(folder, scratch) redness (folder, scratch, drawing));
%! assert (below > 30); assert (below < above/2);
