## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} arc_pendulum ()
## A thin semicircle of steel, hung from one end and let go with its ends level.
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

%!assert (check_scene (arc_pendulum ()).rod.curvature, -2)
