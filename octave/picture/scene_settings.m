## -*- texinfo -*-
## @deftypefn {} {@var{settings} =} scene_settings (@var{drawing}, @var{camera})
## What every picture of the scene has: @code{title} and its font size, @code{zoom} in words, the ranges @code{x} and
## @code{y} (m), the step, scale and unit of their tics, the number of @code{bodies}, and whether there is
## @code{gravity}.
## @end deftypefn

function settings = scene_settings (drawing, camera)
  settings.title = drawing.title;
  ## A long title is set smaller instead of cut.
  settings.title_size = min (20, 1500 / numel (drawing.title));
  settings.zoom = sprintf ("deformation × %g", drawing.zoom);
  settings.x = camera.x;
  settings.y = camera.y;
  settings.metre_step = tic_step (camera.x, 8);
  [settings.metre_scale, settings.metre_unit] = axis_unit (camera.x, "m");
  settings.bodies = numel (drawing.bodies);
  settings.gravity = double (drawing.gravity != 0);
endfunction

%!test
%! drawing = sample_drawing (2);
%! drawing.title = repmat ("a", 1, 150);
%! settings = scene_settings (drawing, fit_camera (drawing, [4 3]));
%! assert (settings.title_size, 10);
%! assert (settings.zoom, "deformation × 300");
%! assert (settings.gravity, 1); assert (settings.bodies, 1); assert (settings.metre_step > 0);
