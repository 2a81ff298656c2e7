## -*- texinfo -*-
## @deftypefn {} {@var{scenes} =} rods_at_rest ()
## Scenes of every kind in which nothing moves, by name: their weight is carried, or there is none.
## @end deftypefn

function scenes = rods_at_rest ()
  rod = struct ("length", 1, "EA", 10, "EI", 0.1, "rhoA", 3);
  rest = struct ("gravity", 0, "duration", 0.1, "frames_per_second", 20);
  scenes.free = setfield (rest, "rod", rod);
  scenes.hanging = setfield (setfield (scenes.free, "gravity", 9.81), "initial", "phi", -pi/2);
  scenes.hub = setfield (scenes.free, "rotation", @(t) [0.3 0 0]);
  scenes.curved = setfield (scenes.free, "rod", "curvature", 1);
  scenes.mechanism = rest;
  scenes.mechanism.bodies = {struct("rod", rod)};
  scenes.mechanism.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
  scenes.mechanism_hanging = setfield (scenes.mechanism, "gravity", 9.81);
  scenes.mechanism_hanging.bodies{1}.initial.phi = -pi/2;
  scenes.plane = setfield (setfield (rest, "rod", rod), "surface", struct ("name", "plane", "inclination", 0));
  scenes.plane.gravity = 9.81;
  scenes.weightless_plane = setfield (scenes.plane, "gravity", 0);
endfunction

%!function check (kind, scene, methods, modes)
%!  for name = methods
%!    if (strcmp (name{1}, "ode15i") || strcmp (name{1}, "ode15s"))
%!      continue;  # a build of Octave may lack them
%!    endif
%!    try
%!      result = driver (scene, "output", "", "solver", name{1}, "modes", modes, "tolerance", 1e-4);
%!    catch err
%!      error ("%s, %s: %s", kind, name{1}, err.message);
%!    end_try_catch
%!    assert (numel (result.history.t), 3);
%!  endfor
%!endfunction
%!function names = methods_of (scene)
%!  kind = kind_of (scene);
%!  scene = kind.check (setfield (scene, "model", "modes", [0 2]));
%!  system = kind.system (scene, kind.build (scene, kind.stated (scene)));
%!  names = {integrator_table(system.forms).name};
%!endfunction
%!test # every method of one rod, rigid and bending
%! check ("free", rods_at_rest ().free, methods_of (rods_at_rest ().free), [0 0]);
%! for kind = {"free", "hanging", "hub", "curved"}
%!   scene = rods_at_rest ().(kind{1});
%!   check (kind{1}, scene, [methods_of(scene), "auto"], [0 2]);
%! endfor
%!test # of mechanisms
%! for kind = {"mechanism", "mechanism_hanging"}
%!   check (kind{1}, rods_at_rest ().(kind{1}), [{integrator_table({"constrained"}).name}, "auto"], [0 1]);
%! endfor
%!test # of rods on surfaces
%! for kind = {"plane", "weightless_plane"}
%!   for ends = {{"free", "free"}, {"clamped", "free"}}
%!     check (kind{1}, setfield (rods_at_rest ().(kind{1}), "ends", ends{1}), {"auto", "ode45", "lsode_adams", "lsode_bdf"}, ...
%!            [4 4]);
%!   endfor
%! endfor
%!test # modes that are chosen
%! for [scene, kind] = rods_at_rest ()
%!   if (! strcmp (kind, "hanging"))
%!     driver (scene, "output", "");
%!   endif
%! endfor
