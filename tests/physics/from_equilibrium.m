## -*- texinfo -*-
## @deftypefn {} {@var{scenes} =} from_equilibrium ()
## Scenes of every kind with weight, springs and loads, by name, which start in equilibrium.
## @end deftypefn

function scenes = from_equilibrium ()
  alone = {"initial", "equilibrium", "duration", 10, "frames_per_second", 2};
  still = @(scene) rmfield (scene, intersect (fieldnames (scene), {"moment", "moment_breaks", "rotation"}));
  scenes.hinged = changed (still (swing ()), alone, "model.modes", [1 2]);
  scenes.sprung = changed (still (slender ()), alone, "model.modes", [0 3], "joints", ...
                           {struct("kind", "torsion_spring", "stations", 0, "stiffness", 5, "damping", 0.01)});
  scenes.hub = changed (spin_up (), alone, "rotation", @(t) [0.3 0 0], "gravity", 9.81, "model.modes", [1 3]);
  scenes.curved = changed (still (arc_pendulum ()), alone, "model.modes", [1 3]);
  scenes.mechanism = changed (chain (2), alone, "solver.tolerance", 1e-8);
  bent = plane_rods ({"clamped", "free"}, [5 5]);
  scenes.surface = changed (bent, alone, "surface.inclination", 0.5, "gravity", 9.81, "force", [0 0.5 0]);
endfunction

function scene = changed (scene, alone, varargin)
  for pair = reshape ([alone, varargin], 2, [])
    scene = setfield (scene, strsplit (pair{1}, "."){:}, pair{2});
  endfor
endfunction

%!test # they stay for ten seconds, and something was bent
%! for [scene, name] = from_equilibrium ()
%!   run = driver (scene, "output", "");
%!   assert ([run.x; run.y], repmat ([run.x(:,1); run.y(:,1)], 1, 21), 1e-10);
%! endfor
%! assert (max (abs (run.y(:,1))) > 0.05);

%!function f = rung_with (times, x)   # from the first time through the mean to the last, upwards
%!  x -= mean (x);
%!  up = find (x(1:end-1) < 0 & x(2:end) >= 0);
%!  crossing = times(up) - x(up).*(times(up+1) - times(up))./(x(up+1) - x(up));
%!  f = (numel (up) - 1)/(crossing(end) - crossing(1));
%!endfunction
%!function check (scene, x_of)
%!  evalc ("table = natural_modes (scene, 'output', tempdir (), 'pictures', false);");
%!  run = driver (scene, "output", "");
%!  assert (rung_with (run.history.t, x_of (run)), table(1).f, -1e-3);
%!endfunction
%!test # beside it they ring with the slowest of the natural frequencies
%! scenes = from_equilibrium ();
%! scene = setfield (setfield (scenes.hinged, "initial", struct ("phi", -pi/2 + 0.01)), "frames_per_second", 100);
%! check (scene, @(run) run.history.phi);
%! scene = setfield (setfield (chain (2), "duration", 5), "frames_per_second", 50);
%! for k = 1:2
%!   scene.bodies{k}.model.modes = [0 0];
%!   scene.bodies{k}.initial.phi = -pi/2 + [0.01 0.0143](k);
%! endfor
%! check (scene, @(run) run.history.bodies(1).phi);
