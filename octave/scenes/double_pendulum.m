## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} double_pendulum ()
## Two equal elastic rods, hinged to the ground and to each other, let go from the horizontal: l = 0.5 m,
## rhoA = 1 kg/m, EA = 1e6 N, EI = 20 N m^2, without rotary inertia.
## @end deftypefn

function scene = double_pendulum ()
  rod = struct ("length", 0.5, "rhoA", 1, "EA", 1e6, "EI", 20, "half_height", 0.008);
  model = struct ("modes", [1 3], "rotary_inertia", false, "energy", "uniaxial", "stiffening", "foreshortening");
  body = struct ("rod", rod, "model", model);
  scene.title = "Elastic double pendulum";
  scene.bodies = {body, body};
  scene.joints = {
    struct("kind", "revolute", "bodies", 1, "stations", 0)
    struct("kind", "revolute", "bodies", [1 2], "stations", [0.5 0])
  };
  scene.duration = 1;
  scene.frames_per_second = 100;
  scene.zoom = 20;
  scene.solver.tolerance = 1e-7;
endfunction

%!test # it can be assembled
%! assembled (double_pendulum (), 1);
