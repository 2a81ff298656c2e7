## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} sample_drawing (@var{frames})
## A drawing (see @code{draw_pictures}) of @code{sample_history}, to test the pictures with.
## @end deftypefn

function drawing = sample_drawing (frames)
  history = sample_history (frames);
  [t, phi] = deal (history.t, history.phi);
  s = linspace (0, 1, 41).';
  wave = history.V(3,:);
  drawing = struct ("title", "Rod with a half wave", "time", t, "frames_per_second", 50, "zoom", 300, ...
                    "gravity", 9.81, "moment", 300 * t .* (t < 0.3), "moment_breaks", 0.3);
  drawing.bodies = turned_rod (s, 300 * sin (pi*s) * wave, phi);
  drawing.bodies.stress = 2.1e11 * 0.015 * pi^2 * abs (sin (pi*s) * wave);
  drawing.hinges = struct ("x", zeros (1, frames), "y", zeros (1, frames));
  drawing.strips = rod_strips (history, drawing.moment, 1);
  drawing.panels = rod_panels (history, 1);
  drawing.equations = {"hinged", "straight"};
endfunction

function body = turned_rod (s, v, phi)
  body = struct ("x", s .* cos (phi) - v .* sin (phi), "y", s .* sin (phi) + v .* cos (phi), ...
                 "rest_x", s .* cos (phi), "rest_y", s .* sin (phi), "half_height", 0.015);
endfunction

%!test
%! drawing = sample_drawing (5);
%! assert (size (drawing.bodies.x), [41, 5]);
%! assert (drawing.bodies.x(end,:), sample_history (5).tip_x, 1e-12);
