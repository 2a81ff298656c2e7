## -*- texinfo -*-
## @deftypefn {} {[@var{alone}, @var{joints}] =} held_rods (@var{scene}, @var{tolerance})
## What holds the rod of a @var{scene} at O, and the same of the mechanism of one body on a revolute joint, turned by a
## joint where the scene has a rotation: rows of the reaction (N) and of the hub's torque (N m, else 0), a column a
## frame.
## @end deftypefn

function [alone, joints] = held_rods (scene, tolerance)
  rod = driver (scene, "output", "", "tolerance", tolerance).history;
  alone = [rod.reaction_x; rod.reaction_y; 0*rod.t];
  if (! isempty (rod.torque))
    alone(3,:) = rod.torque;
  endif
  bodies = as_bodies (setfield (scene, "joints", {}));
  held = driver (bodies, "output", "", "tolerance", tolerance).history.joints;
  joints = [held(1).reaction_x; held(1).reaction_y; 0*rod.t];
  for joint = held(2:end)
    joints += [joint.reaction_x; joint.reaction_y; joint.torque];
  endfor
endfunction

%!function scene = bent (varargin)
%!  scene.rod = struct ("length", 1, "EA", 1e3, "EI", 2, "rhoA", 1, "rhoI", 1e-3, "damping", 1e-3);
%!  scene.model = struct ("modes", [1 2], "stiffening", "foreshortening");
%!  [scene.duration, scene.frames_per_second, scene.tip_mass] = deal (0.3, 20, 0.2);
%!  scene.initial = struct ("phi", -0.3, "V2", [0.05 0.01]);
%!  scene.force = @(t) [1 + t, -2];
%!  for k = 1:2:numel (varargin)
%!    scene.(varargin{k}) = varargin{k+1};
%!  endfor
%!endfunction
%!function agree (scene, scale)
%!  [alone, joints] = held_rods (scene, 1e-9);
%!  assert (max (max (abs (joints))) > scale);
%!  assert (alone, joints, 1e-4*scale);
%!endfunction
%!test # a hinged rod that bends and stretches, with a tip mass, a moment, and a force at its tip
%! agree (bent ("moment", 0.4), 10);
%!test # in a hub, whose torque is the other joint's
%! agree (bent ("rotation", @(t) [t^2, 2*t, 2], "initial", struct ()), 5);
%!test # a curved rod
%! scene = setfield (bent (), "rod", "curvature", 1);
%! scene.model = rmfield (scene.model, "stiffening");
%! agree (rmfield (scene, {"tip_mass", "force"}), 5);
