## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} large_swing ()
## A very soft rod falls from the horizontal, hinged at its end, in a vertical plane: the geometrically exact rod.
## @end deftypefn

function scene = large_swing ()
  scene.title = "A very soft rod falls";
  scene.surface = struct ("name", "plane", "inclination", pi/2, "side", 0);
  scene.rod = struct ("length", 1, "EA", 2e3, "EI", 0.05, "rhoA", 0.1, "half_height", 0.01);
  scene.ends = {"hinge", "free"};
  scene.duration = 1.6;
  scene.view = struct ("elevation", 12, "azimuth", -75);
endfunction

%!assert (large_swing ().surface.name, "plane")
