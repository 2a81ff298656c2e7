## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} sample_surface (@var{frames})
## A drawing for tests (see @code{draw_surface_frames}): a rod on a level plane.
## @end deftypefn

function drawing = sample_surface (frames)
  drawing = sample_drawing (frames);
  [x, y] = meshgrid (linspace (-2, 2, 9));
  drawing.surface.patch = struct ("x", x, "y", y, "z", 0*x, "shade", 0.5 + 0*x);
  drawing.surface.rod = struct ("x", drawing.bodies.x, "y", drawing.bodies.y, "z", 0.02 + 0*drawing.bodies.x);
  drawing.surface.room = 0.1;
  drawing.surface.held = [false false];
  drawing.surface.elevation = 40;
  drawing.surface.azimuth = 10*(1:frames);
  drawing.backdrop = {[x(:,1), y(:,1)], [x(:,9), y(:,9)]};
endfunction

%!test check_drawing (sample_surface (3));
