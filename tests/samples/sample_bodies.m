## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} sample_bodies (@var{frames})
## A drawing (see @code{draw_pictures}) of two bodies to test the pictures with: a crank that turns on the ground, and
## a rod that hangs from it by a pin, without a moment, gravity or stress.
## @end deftypefn

function drawing = sample_bodies (frames)
  t = linspace (0, 1, frames);
  pin = 0.3 * exp (2i*pi*t);
  rod = pin + linspace (0, 1, 21).' * exp (-1i*pi/2 + 0.4i*sin (2*pi*t));
  bend = 0.05 * sin (pi*linspace (0, 1, 21).') .* sin (4*pi*t) .* exp (0.4i*sin (2*pi*t));
  drawing = struct ("title", "Crank and rod", "time", t, "frames_per_second", 30, "zoom", 1, "gravity", 0, ...
                    "moment", 0*t, "moment_breaks", []);
  drawing.bodies = [body_of([0*t; pin], [0*t; pin], 0.02), body_of(rod + bend, rod, 0.01)];
  drawing.hinges = struct ("x", real ([0*t; pin]), "y", imag ([0*t; pin]), "ground", [true; false]);
  drawing.strips = new_panel ("pin", "m", {"x", "y"}, [real(pin); imag(pin)]);
  drawing.panels = drawing.strips;
  drawing.equations = {"mechanism"};
endfunction

function body = body_of (z, rest, half_height)
  body = struct ("x", real (z), "y", imag (z), "rest_x", real (rest), "rest_y", imag (rest), ...
                 "half_height", half_height, "stress", []);
endfunction

%!test # the rod hangs from the crank's end
%! drawing = sample_bodies (5);
%! assert (drawing.bodies(1).x(2,:), drawing.bodies(2).x(1,:), 1e-15);
