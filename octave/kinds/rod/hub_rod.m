## -*- texinfo -*-
## @deftypefn {} {@var{system} =} hub_rod (@var{scene}, @var{model})
## The rod clamped in a hub that is turned by scene.rotation, as a system of first order with the state
## y = (V; V_dot; W; D); fields as in @code{hinged_rod}.  W is the work of the hub and of the other loads.
## @end deftypefn

function system = hub_rod (scene, model)
  n = columns (model.basis);
  constants = rod_constants (scene, model);
  system = common_of_rod (scene, model, constants);
  a = model.arrays;
  P = [eye(n); -a.slope_2.'];
  system.mass = P.'*mass_with_rotation (a)*P;
  [stiffness, damping] = linear_rod (scene.rotation (0)(1), constants);
  system.stiffness = P.'*stiffness*P;
  damping = P.'*damping*P;
  if (any (damping(:)))
    system.damping_matrix = damping;
  endif
  turning = @(t, V, theta) turning_stiffness (t, V, theta(1), theta(2), constants);
  system.stiffness_at = @(t, y) P.'*turning (t, y(1:n), scene.rotation (t))*P;
  system.velocity_matrix = eye (n);
  start = initial_coordinates (scene.initial, model, -a.slope_2);
  system.initial_state = [start(1:n,1); start(1:n,2); 0; 0];
  system.rate = @(t, y) hub_rod_rate (t, y, n, constants);
  system.motion = @(times, states) motion (times, states, n, constants);
  system.forces = @(t, q, v) forces (t, q, v, constants);
  system.accelerations = struct ("rate", system.rate, "state", @(z) z, "form", @(y) y);
  system.forms = {"rate", "oscillators", "accelerations"};
  system.refusal = "it takes no prescribed rotation; take generalized_alpha or waveform";
  system.energy_rows = numel (system.initial_state) + [-1, 0];
  system.state_scale = state_scale (model, scene, ones (n, 1));
endfunction

## generalized, of the coordinates alone: phi follows them, and the hub (see hub_accelerations)
function f = forces (t, V, V_dot, c)
  theta = c.rotation (t);
  within = struct ("V", V, "V_dot", V_dot);
  [phi, phi_dot, gradient, acceleration] = rod_in_hub (theta(1,:), theta(2,:), within, c.rod);
  [m, mm, force_V, force_phi] = rod_forces (t, phi, phi_dot, V, V_dot, c);
  r = theta(3,:) - acceleration;
  f = force_V - m.*r + gradient.*(mm.*r - force_phi);
endfunction

function found = motion (times, states, n, c)
  found.q = states(1:n,:);
  found.q_dot = states(n+1:2*n,:);
  theta = c.rotation (times);
  within = struct ("V", found.q, "V_dot", found.q_dot);
  [found.phi, found.phi_dot] = rod_in_hub (theta(1,:), theta(2,:), within, c.rod);
  [rates, found.torque, phi_ddot] = hub_rod_rate (times, states, n, c);
  [found.reaction_x, found.reaction_y] = reaction_at_O (times, found, rates(n+1:2*n,:), phi_ddot, c);
endfunction

%!test # the tangent at O has the hub's angle
%! scene = check_scene (setfield (spin_up (), "duration", 2));
%! scene.model.modes = [0 3];
%! history = driver (scene, "output", "").history;
%! theta = cell2mat (arrayfun (@(t) scene.rotation (t).', history.t, "uniformoutput", false));
%! assert (history.psi, theta(1,:), 1e-12);
%! assert (numel (history.torque), numel (history.t));
%!error <solver.name is "trigonometric": it takes no prescribed rotation; take generalized_alpha or waveform>
%! scene = check_scene (setfield (setfield (spin_up (), "model", "modes", [0 1]), "solver", "name", "trigonometric"));
%! rod_system (scene, build_model (scene, rung_of_scene (scene)));
%!test # it starts from its initial state, and with no work
%! scene = setfield (spin_up (), "initial", struct ("V2", [1e-3 2e-3], "V2_dot", [3e-3 0]));
%! scene = check_scene (setfield (scene, "model", "modes", [0 2]));
%! system = hub_rod (scene, build_model (scene, rung_of_scene (scene)));
%! assert (system.initial_state(5:6), [0; 0]); assert (norm (system.initial_state(1:2)) > 1e-3);
