## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} cylinder ()
## A straight rod is let go aslant across a lying cylinder's inside: it slides down, swings, and its stiffness turns it
## towards the rulings.
## @end deftypefn

function scene = cylinder ()
  scene.title = "A rod slides across the inside of a lying cylinder";
  scene.surface = struct ("name", "cylinder", "radius", 0.5);
  scene.rod = struct ("length", 0.8, "EA", 2e3, "EI", 0.02, "rhoA", 0.2, "half_height", 0.008);
  scene.initial = struct ("point", [-0.35 0], "angle", 0.75);
  scene.duration = 2;
  scene.view = struct ("elevation", 40, "azimuth", -55);
endfunction

%!assert (cylinder ().surface.radius, 0.5)
