## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} sample_drawing (@var{frames})
## A drawing to test the pictures with: a rod of 1 m that turns once and bends in a half wave, seen in @var{frames}
## frames over 1.8 s. See @code{draw_pictures} for the fields.
## @end deftypefn

function drawing = sample_drawing (frames)
  t = linspace (0, 1.8, frames);
  phi = -pi/6 + 2*pi * (t/1.8).^2;
  s = linspace (0, 1, 41).';
  wave = 5e-4 * sin (12*t);
  moment = 300 * t .* (t < 0.3);
  drawing = struct ("title", "Rod with a half wave", "time", t, "frames_per_second", 50, "zoom", 300, ...
                    "gravity", 9.81, "moment", moment, "moment_breaks", 0.3);
  drawing.bodies = turned_rod (s, 300 * sin (pi*s) * wave, phi);
  drawing.bodies.stress = 2.1e11 * 0.015 * pi^2 * abs (sin (pi*s) * wave);
  drawing.hinges = struct ("x", zeros (1, frames), "y", zeros (1, frames));
  T = 0.78 * (4*pi*t/1.8^2).^2;
  Z = 23 * sin (phi);
  drawing.history = struct ("t", t, "phi", phi, "psi", phi + pi*wave, "phi_dot", 4*pi*t/1.8^2, ...
                            "tip_x", cos (phi), "tip_y", sin (phi), "T", T, "U", 1e6 * wave.^2, "Z", Z, ...
                            "W", T + Z - Z(1), "D", 0*t, "V", [1e-7 * [cos(9*t); sin(9*t)]; wave; wave.^2], ...
                            "torque", [], "V_names", {{"V1_1", "V1_2", "V2_1", "V2_2"}});
endfunction

function body = turned_rod (s, v, phi)
  body = struct ("x", s .* cos (phi) - v .* sin (phi), "y", s .* sin (phi) + v .* cos (phi), ...
                 "rest_x", s .* cos (phi), "rest_y", s .* sin (phi), "half_height", 0.015);
endfunction

%!test
%! drawing = sample_drawing (5);
%! assert (size (drawing.bodies.x), [41, 5]);
%! assert (drawing.bodies.x(end,:), drawing.history.tip_x, 1e-12);
