## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} torus_pendulum ()
## A checked scene of a curved rod that hangs by a hinge on a torus, with all that acts on a rod on a surface without a
## hub: damping, rotary inertia, torsion, a tip mass, loads at its ends and between them, and a spring with a damper.
## @end deftypefn

function scene = torus_pendulum ()
  scene = struct ("surface", struct ("name", "torus", "core_radius", 1, "tube_radius", 0.4), "duration", 1, ...
                  "rod", struct ("length", 1, "EA", 100, "EI", 0.1, "EI_normal", 0.2, "GJ", 0.3, "rhoA", 2, ...
                                 "rhoI", 0.4, "damping", 0.2, "curvature", [0.3 0.4]), "tip_mass", 0.7, ...
                  "ends", {{"hinge", "free"}}, "model", struct ("modes", [4 5]), ...
                  "tip_moment", 0.3, "force", [1 2 3]);
  scene.initial = struct ("angle", 1);
  scene.joints = {struct("kind", "spring", "stations", 0.6, "point", [1 2 3], "stiffness", 5, "damping", 3, ...
                         "rest", 0.2)
                  struct("kind", "force", "stations", 0.3, "value", [2 1 -1])
                  struct("kind", "moment", "stations", 0.3, "value", 0.4)};
  scene = check_surface_scene (scene);
endfunction

%!test
%! scene = torus_pendulum ();
%! assert ({scene.joints.kind}, {"spring", "force", "moment"}); assert (scene.ends, {"hinge", "free"});
