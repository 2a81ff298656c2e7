## -*- texinfo -*-
## @deftypefn {} {[@var{system}, @var{start}, @var{scene}] =} sample_mechanism (@var{modes})
## A mechanism to test with: a double pendulum of rods of 0.5 m with @var{modes} = [N1 N2] each, a spring and damper
## between its links, a slider that is a third rod's, and a force that grows.
## @end deftypefn

function [system, start, scene] = sample_mechanism (modes)
  rod = struct ("length", 0.5, "EA", 1e4, "EI", 20, "rhoA", 1, "rhoI", 1e-4, "damping", 1e-4);
  body = struct ("rod", rod, "model", struct ("modes", modes, "energy", "uniaxial", "stiffening", "foreshortening"));
  loose = setfield (setfield (body, "initial", struct ("x", 0.8, "y", -0.1, "phi", 1)), "tip_mass", 0.5);
  scene.bodies = {body, body, loose};
  scene.joints = {
    struct("kind", "revolute", "bodies", 1, "stations", 0)
    struct("kind", "revolute", "bodies", [1 2], "stations", [0.5 0])
    struct("kind", "slider", "bodies", [3 2], "stations", [0 0.4])
    struct("kind", "torsion_spring", "bodies", [1 2], "stations", [0.5 0], "stiffness", 2, "damping", 0.1)
    struct("kind", "spring", "bodies", [3 0], "stations", 0.5, "point", [2 1], ...
           "stiffness", 5, "damping", 0.1, "rest", 1)
    struct("kind", "force", "bodies", 2, "stations", 0.25, "value", @(t) [t, 1])
  };
  scene.duration = 0.5;
  scene = check_mechanism (scene);
  system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, [0 0 0])));
  start = assemble_mechanism (scene, system.mechanism, system);
endfunction

%!test
%! [system, start] = sample_mechanism ([1 2]);
%! assert (system.n, 18); assert (system.constraint_count, 5);
%! assert (abs (system.at (0, start.q, start.v).constraints.residual) < 1e-12);
