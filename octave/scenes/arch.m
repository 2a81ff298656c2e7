## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} arch ()
## The deep circular arch of DaDeppo and Schmidt (J. Appl. Mech. 42, 1975): 215 degrees of a ring of 1 m, clamped at its
## left end, hinged at the right one, under a force at its apex.  With E I = 1 N m^2 a factor of the load (`make statics
## SCENE=arch FACTOR=0:0.5:10') is P R^2/(E I): the arch sways to its hinge, and turns over at 8.97.
## @end deftypefn

function scene = arch ()
  half = deg2rad (215)/2;
  scene.title = "A deep arch under a force";
  scene.surface = struct ("name", "plane", "inclination", pi/2, "side", 0);
  scene.rod = struct ("length", 2*half, "curvature", -1, "EA", 1e5, "EI", 1, "rhoA", 1);
  scene.ends = {"clamped", "hinge"};
  scene.initial = struct ("point", [-sin(half), cos(half)], "angle", half);
  scene.force = [0 0 -1];
  scene.force_station = half;
  scene.gravity = 0;
  scene.view = struct ("elevation", 0, "azimuth", -90);
  scene.duration = 2;
endfunction

%!test # it lies on the ring, with the force at its top
%! scene = setfield (setfield (check_surface_scene (arch ()), "model", "modes", [24 24]), "force", [0 0 0]);
%! system = surface_rod (scene);
%! z = system.initial_state(1:system.n);
%! fields = system.fields (0, z, z, z, linspace (0, scene.rod.length, 9).');
%! assert (hypot (fields.alpha1, fields.alpha2), ones (9, 1), 1e-8);
%! assert ([fields.alpha1(5), fields.alpha2(5)], [0 1], 1e-8);
%! assert (system.energies (0, z, 0*z)(2), 0, 1e-9);
