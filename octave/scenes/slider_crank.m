## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} slider_crank ()
## A crank that turns at 150 rad/s, an elastic connecting rod and a sliding block, with the data of B. Simeon,
## Modelling a flexible slider crank mechanism by a mixed system of DAEs and PDEs, Math. Modelling
## of Systems 2, 1996; no weight.
## @end deftypefn

function scene = slider_crank ()
  scene.title = "Slider-crank with an elastic connecting rod (Simeon, 1996)";
  [l_1, l_2, omega] = deal (0.15, 0.30, 150);
  crank = struct ("rod", struct ("length", l_1, "rhoA", 0.36/l_1, "EA", 1e9, "EI", 1e5, "half_height", 0.006), ...
                  "model", struct ("modes", [0 0]), "initial", struct ("phi_dot", omega));
  section = struct ("length", l_2, "rhoA", 7870*0.008^2, "EA", 0.2e12*0.008^2, "EI", 0.2e12*0.008^4/12, ...
                    "half_height", 0.004, "width", 0.008);
  rod = struct ("rod", section, "tip_mass", 0.075552, "initial", struct ("phi_dot", -omega*l_1/l_2), ...
                "model", struct ("modes", [2 2], "energy", "uniaxial", "rotary_inertia", false, "stiffening", "none"));
  scene.bodies = {crank, rod};
  scene.joints = {
    struct("name", "crankshaft", "kind", "revolute", "bodies", 1, "stations", 0)
    struct("name", "motor", "kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [omega*t, omega, 0])
    struct("name", "crank pin", "kind", "revolute", "bodies", [1 2], "stations", [l_1 0])
    struct("name", "guide of the block", "kind", "slider", "bodies", 2, "stations", l_2)
  };
  scene.gravity = 0;
  scene.duration = 0.1;
  scene.frames_per_second = 1000;
  scene.zoom = 50;
  scene.solver.tolerance = 5e-9;  # of the balance: 1e-8 would leave 1.07e-7
endfunction

%!test # it can be assembled
%! assembled (slider_crank (), 1);
