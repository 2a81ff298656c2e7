## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} arc_pendulum ()
## A thin semicircle of steel, hung from one end and let go with the other 61 degrees below the level.
## @end deftypefn

function scene = arc_pendulum ()
  scene.title = "A semicircle swings about one of its ends";
  scene.rod = struct ("length", 0.5*pi, "width", 0.02, "half_height", 0.003, "curvature", -2);
  scene.model.energy = "uniaxial";
  scene.initial.phi = -0.5;
  scene.duration = 2;
  scene.zoom = 5;
  scene.solver.tolerance = 2e-4;
endfunction

%!test # a semicircle: its ends are a diameter of 1 m apart, and its middle is not on their line
%! scene = setfield (arc_pendulum (), "duration", 1e-3);
%! history = driver (scene, "modes", [0 0], "output", "").history;
%! assert (hypot (history.tip_x(1), history.tip_y(1)), 1, 1e-9);
%! assert (atan2 (history.tip_y(1), history.tip_x(1)), scene.initial.phi - atan (2/pi), 1e-5);
