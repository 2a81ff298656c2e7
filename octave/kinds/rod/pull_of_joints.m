## -*- texinfo -*-
## @deftypefn {} {@var{pull} =} pull_of_joints (@var{t}, @var{motion}, @var{joined})
## What the springs and loads of a @code{joined_rod} do to it at the times @var{t} (1-by-k), in a @var{motion}, a
## struct of phi, phi_dot (1-by-k), V and V_dot (n-by-k): a struct of V (n-by-k, N), phi (1-by-k, N m), x and y (N),
## the generalized forces, taken (W), the power that springs and dampers take from the rod, dissipated (W), of the
## dampers alone, and energy (J), of the springs (1-by-k).
## @end deftypefn

function pull = pull_of_joints (t, motion, joined)
  motion.x = motion.y = motion.x_dot = motion.y_dot = zeros (size (motion.phi));
  at = marker_motion (joined, columns (motion.phi), @(group) motion);
  springs = spring_forces (joined, at);
  forces = -forces_of_markers (joined, at, reactions (joined, joined.springs, springs, springs.tension));
  if (! isempty (joined.loads))
    forces += forces_of_markers (joined, at, applied_forces (joined, applied_values (joined.loads, t), at));
  endif
  pull = struct ("V", forces(1:end-3,:), "phi", forces(end-2,:), "x", forces(end-1,:), "y", forces(end,:), ...
                 "energy", springs.energy, ...
                 "taken", sum (springs.tension.*springs.velocity, 1), "dissipated", springs.dissipated);
endfunction

%!function [joined, motion] = sample ()
%!  joint = @(kind, station, value) struct ("kind", kind, "stations", station, "point", [1 1], "value", value, ...
%!                                          "stiffness", 50, "damping", 3);
%!  joints = {joint("spring", 1, 0), joint("torsion_spring", 0, 0), joint("bushing", 0.5, 0)};
%!  loads = {joint("force", 0.7, [3 4]), joint("moment", 1, 5)};
%!  [scene, model] = sample_rod ([2 2], "joints", [joints, loads], "model.stiffening", "foreshortening");
%!  joined = joined_rod (model, scene.joints);
%!  motion = struct ("phi", 0.3, "V", [1; -2; 3; 1]/100, "phi_dot", 2, "V_dot", [3; 1; -2; 2]);
%!endfunction
%!test # its power is what the springs' energy gains, the dampers dissipate and the loads do
%! [joined, motion] = sample ();
%! moved = @(s) setfield (setfield (motion, "V", motion.V + s*motion.V_dot), "phi", motion.phi + s*motion.phi_dot);
%! energy = @(s) pull_of_joints (0, moved (s), joined).energy;
%! pull = pull_of_joints (0, motion, joined);
%! h = 1e-6;
%! gained = (energy (h) - energy (-h))/(2*h);
%! assert (pull.taken, gained + pull.dissipated, 1e-6*abs (gained));
%! joined.loads = struct ([]);
%! alone = pull_of_joints (0, motion, joined);
%! power = motion.V_dot.'*alone.V + motion.phi_dot*alone.phi;
%! assert (power, -pull.taken, 1e-12*abs (power));
