## -*- texinfo -*-
## @deftypefn {} {@var{system} =} hinged_rod (@var{scene}, @var{model})
## The hinged rod as a system of first order, y_dot = rate (t, y), with the state y = (q; phi; q_dot; p; W;
## D): coordinates of the model's basis, rotation, the coordinates' rates, angular momentum, work of the loads,
## dissipated energy.  (The angular momentum feels no stiffness: its rate is smooth where phi's is not.)
##
## Fields: initial_state, rate, motion (times, states) = a struct of q, q_dot (n-by-m), phi, phi_dot (1-by-m), torque
## (of a hub, else empty) and reaction_x, reaction_y (N, of the support at O on the rod), energies (phi, phi_dot, q,
## q_dot) = [T; U; Z], forces (t, q, v) = what mass times accelerations is, mass and stiffness (of the coordinates,
## linear about the undeformed rod), stiffness_at (t, y) (of the rod as it turns), damping_matrix (where there is
## damping), joined (see @code{joined_rod}), longest_step (s), velocity_matrix (the second part of y per rates of the
## coordinates, likewise), momenta and accelerations (other forms of the same, see @code{momenta_of_rod} and
## @code{accelerations_of_rod}), turned (see @code{integrate_explicit}: the paper's sines are integrated as they are),
## breaks (times in s at which a load jumps), steepest (y) (the largest slope of a state) and state_scale, what each
## state may be off by where a centreline point is off by 1 m; forms, refusal and auto (see @code{integrate}),
## warnings, duration (s), gravity (m/s^2), force (t) of the scene, energy_rows (of W and D in y).
## @end deftypefn

function system = hinged_rod (scene, model)
  n = columns (model.basis);
  constants = rod_constants (scene, model);
  system = common_of_rod (scene, model, constants);
  a = model.arrays;
  system.mass = mass_with_rotation (a);
  [system.stiffness, damping] = linear_rod (scene.initial.phi, constants);
  if (any (damping(:)))
    system.damping_matrix = damping;
  endif
  system.stiffness_at = @(t, y) turning_stiffness (t, y(1:n), y(n+1), y(2*n+2)/a.moment_of_inertia, constants);
  system.velocity_matrix = [eye(n, n + 1); system.mass(end,:)];
  system.initial_state = initial_state (scene.initial, model, constants);
  system.rate = @(t, y) hinged_rod_rate (t, y, n, constants);
  system.motion = @(times, states) motion (times, states, n, constants);
  system.forces = @(t, q, v) forces (t, q, v, n, constants);
  system.momenta = momenta_of_rod (n, constants, system.mass, system.stiffness);
  system.accelerations = accelerations_of_rod (n, constants);
  system.forms = {"rate", "oscillators"};
  if (constants.pulls_followers)  # the other forms are made of the state without the time
    system.refusal = ["with longitudinal modes without inertia a force changes the momentum of phi at once; take" ...
                      " waveform, or model.axial = \"dynamic\""];
  else
    system.forms = [system.forms, {"momenta", "accelerations"}];
  endif
  system.energy_rows = numel (system.initial_state) + [-1, 0];
  system.state_scale = state_scale (model, scene, [ones(n, 1); 1/model.length]);
endfunction

function y = initial_state (initial, model, c)
  n = columns (model.basis);
  start = initial_coordinates (initial, model, []);
  start(n+1,:) += [initial.phi, initial.phi_dot];
  ## followers take their places at once, and the angular momentum stays
  c.rod.follower_dd = c.rod.follower_ds = c.rod.follower_ss = 0;
  [~, p] = rod_energies_of (start(n+1,1), start(n+1,2), start(1:n,1), start(1:n,2), c);
  y = [start(:,1); start(1:n,2); p; 0; 0];
endfunction

## generalized, of the coordinates and phi
function f = forces (t, q, v, n, c)
  [~, ~, force_V, force_phi] = rod_forces (t, q(n+1,:), v(n+1,:), q(1:n,:), v(1:n,:), c);
  f = [force_V; force_phi];
endfunction

function found = motion (times, states, n, c)
  found = struct ("q", states(1:n,:), "q_dot", states(n+2:2*n+1,:), "phi", states(n+1,:), "torque", []);
  [rates, phi_ddot] = hinged_rod_rate (times, states, n, c);
  found.phi_dot = rates(n+1,:);
  [found.reaction_x, found.reaction_y] = reaction_at_O (times, found, rates(n+2:2*n+1,:), phi_ddot, c);
endfunction

%!test # at rest and undeformed: the rod falls as a rigid one begins to
%! [scene, model] = sample_rod ([0 0]);
%! system = hinged_rod (scene, model);
%! y_dot = system.rate (1, system.initial_state);
%! J = 7800*6e-4/3 + 7800*0.02*2*0.015^3/3; S = 7800*6e-4/2;
%! assert (y_dot(2), -9.81*S*cos (pi/6), 1e-12);
%!error <"trigonometric": with longitudinal modes without inertia a force changes .*; take waveform, or model.axial>
%! scene = setfield (paper (), "force", @(t) [1 0]);
%! scene.model = struct ("modes", [1 1], "axial", "quasistatic");
%! scene = check_scene (setfield (scene, "solver", "name", "trigonometric"));
%! rod_system (scene, build_model (scene, rung_of_scene (scene)));
%!test # damping is the material's, in proportion to its stiffness; work and what dissipates begin with none
%! scene = check_scene (setfield (damped (), "model", "modes", [1 2]));
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! assert (system.damping_matrix, scene.rod.damping*system.stiffness, 1e-9*norm (system.damping_matrix));
%! assert (system.initial_state(system.energy_rows), [0; 0]);
%! assert (system.energy_rows, numel (system.initial_state) - [1 0]);
%! assert (system.duration, scene.duration); assert (system.gravity, scene.gravity); assert (system.warnings, {});
%! assert (! system.turned);  # the paper's sines
%! turned = setfield (paper (), "initial", struct ("phi", 1, "phi_dot", 3));
%! scene = check_scene (setfield (turned, "model", "modes", [0 0]));
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! assert (system.initial_state, [1; 3*system.mass; 0; 0], 1e-12);
%! assert (system.motion (0, system.initial_state).phi_dot, 3, 1e-12);
