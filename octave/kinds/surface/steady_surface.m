## -*- texinfo -*-
## @deftypefn {} {@var{turning} =} steady_surface (@var{scene})
## The rod of a checked @var{scene} on a surface in steady rotation with its hub, without weight and loads, as
## @code{campbell} takes it: a struct of speed (rad/s, the largest that the hub has) and about (speed, q), the equations
## linear about that and the coordinates then, found near @var{q}, as @code{about_rotation} returns them.  Without
## stated modes it has 20 + 20 polynomials.  A scene without a hub is an error.
## @end deftypefn

function turning = steady_surface (scene)
  if (isempty (scene.rotation))
    scene_error ("no steady rotation: a rod on a surface turns in a hub, rotation and a clamped end, on a plane or sphere");
  endif
  turning.speed = fastest_rotation (scene.rotation, scene.duration);
  [scene.gravity, scene.moment, scene.tip_moment, scene.force, scene.joints] = deal (0, 0, 0, [0 0 0], scene.joints([]));
  scene.initial.velocity = [];
  scene.solver.tolerance = 1e-9;
  if (ischar (scene.model.modes))
    scene.model.modes = [20 20];
  endif
  turning.about = @(speed, q) about (setfield (scene, "rotation", @(t) [0 speed 0]), q);
endfunction

function [linear, q] = about (scene, q)
  system = surface_rod (scene);
  balance = surface_at_rest (scene, system, system);
  if (isempty (q))
    q = balance.start;
  endif
  [q, ~, linear] = equilibrium (balance, 0, q);
endfunction

%!function scene = turning_on (surface)   # of unit length, mass and EI
%!  scene = struct ("surface", surface, "ends", {{"clamped", "free"}}, "duration", 1, "rotation", @(t) [0 0 0], ...
%!                  "rod", struct ("length", 1, "EA", 1e8, "EI", 1, "rhoA", 1));
%!endfunction
%!test # on a plane: the table of Wright, Smith, Thresher and Wang (1982), in the plane of rotation
%! scene = turning_on (struct ("name", "plane", "inclination", 1));
%! scene.force = [0 3 0];  # weight and loads are left out
%! turning = steady_surface (check_surface_scene (scene));
%! flapping = [3.5160 5.5850 13.1702];
%! q = [];
%! for k = 1:3
%!   speed = [0 4 12](k);
%!   [linear, q] = turning.about (speed, q);
%!   assert (vibrations (linear).omega(1), sqrt (flapping(k)^2 - speed^2), 2e-4);
%! endfor
%! assert (turning.speed, 0);
%!error <no steady rotation: a rod on a surface turns in a hub>
%! scene = turning_on (struct ("name", "plane", "inclination", 0));
%! steady_surface (check_surface_scene (rmfield (scene, "rotation")));
