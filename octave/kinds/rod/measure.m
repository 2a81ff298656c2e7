## -*- texinfo -*-
## @deftypefn {} {@var{history} =} measure (@var{system}, @var{model}, @var{times}, @var{states})
## What is observed at the frame times: a struct of 1-by-m rows t, phi, phi_dot, psi and tip_psi (the tangent's angles
## at O and at the tip), tip_x, tip_y, mid_x, mid_y (the centreline's places there and at mid-span), T, U, Z, W, D,
## balance (T + U + Z + D - W, constant), reaction_x, reaction_y (N, of the support at O on the rod) and torque (of a
## hub, else empty), joint_points (see @code{points_of_joints}), energy_floor (J), and the coordinates q (n-by-m) and
## amplitudes V (N-by-m) of all base functions, with their names V1_1, ..., V2_1, ... (see @code{mode_names}).
## @end deftypefn

function history = measure (system, model, times, states)
  motion = system.motion (times, states);
  history.t = times;
  history.phi = motion.phi;
  history.phi_dot = motion.phi_dot;
  history.torque = motion.torque;
  history.reaction_x = motion.reaction_x;
  history.reaction_y = motion.reaction_y;
  history.q = motion.q;
  history.V = model.basis*motion.q;
  N1 = numel (model.base.longitudinal);
  followers = model.followers;
  a = model.arrays;
  force = zeros (2, numel (times));
  if (! isempty (system.force))
    force = at_times (system.force, times);
  endif
  loads = struct ("force_x", force(1,:), "force_y", force(2,:));
  if (! isempty (followers))
    history.V(1:N1,:) = rod_followers (motion, followers, system.gravity, loads);
  endif
  history.psi = rod_tangent_angle (struct ("phi", motion.phi, "V", motion.q), a) + ...
      nthargout (3, @undeformed_places, model.base, 0);
  history.tip_psi = tangent_at (model, model.length, motion.phi, history.V);
  E = system.energies (motion.phi, motion.phi_dot, motion.q, motion.q_dot);
  [T, U, Z, W] = rod_pulled_followers (motion, system.gravity, loads, a);
  history.T = E(1,:) + T;
  history.U = E(2,:) + U;
  history.Z = E(3,:) + Z;
  history.V_names = mode_names (model.base);
  [history.tip_x, history.tip_y] = centreline (model, model.length, history, 1);
  [history.mid_x, history.mid_y] = centreline (model, model.length/2, history, 1);
  history.W = states(end-1,:) + W;
  history.D = states(end,:);
  history.balance = history.T + history.U + history.Z + history.D - history.W;
  history.joint_points = points_of_joints (system.joined, motion.q, motion.phi);
  history.energy_floor = energy_floor (a.moment_of_inertia, system.duration);
endfunction

%!test # a rigid rod at rest
%! [scene, model] = sample_rod ([0 0]);
%! history = measure (system = hinged_rod (scene, model), model, 0, system.initial_state);
%! assert ([history.tip_x, history.tip_y], [cos(pi/6), -0.5], 1e-12);
%! assert (history.psi, -pi/6, 1e-12);
%! assert (history.balance, -7800*0.02*0.03*9.81*0.25, 1e-12);
