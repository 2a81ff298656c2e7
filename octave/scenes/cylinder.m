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

%!test # aslant across the inside: its ends differ along the cylinder and in height, and it slides down from rest
%! scene = cylinder ();
%! [scene.duration, scene.model.modes] = deal (0.04, [4 4]);
%! history = driver (scene, "output", "").history;
%! assert (abs (history.x(end,1) - history.x(1,1)) > 0.1 && abs (history.y(end,1) - history.y(1,1)) > 0.1);
%! assert (history.T(1), 0); assert (history.Z(end) < history.Z(1));
