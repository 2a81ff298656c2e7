## -*- texinfo -*-
## @deftypefn {} {@var{history} =} measure_mechanism (@var{system}, @var{times}, @var{states})
## What is observed of a mechanism at the frame times: a struct of 1-by-m rows t, T, U, Z, W, D, balance (T + U + Z +
## D - W, constant), energy_floor (J), lambda (constraints-by-m), joints (see @code{joint_forces}), markers (x, y:
## markers-by-m), residual and velocity_residual (the largest of all constraints, 1-by-m) and bodies (a struct array of
## phi, phi_dot, psi and tip_psi (the tangent's angles at both ends), x, y, tip_x, tip_y, mid_x, mid_y (1-by-m),
## V (N-by-m) and V_names).
## @end deftypefn

function history = measure_mechanism (system, times, states)
  mechanism = system.mechanism;
  at = system.at (times, states.q, states.v);
  E = system.energies (states.q, states.v, at);
  history = struct ("t", times, "T", E(1,:), "U", E(2,:), "Z", E(3,:), "W", states.W, "D", states.D);
  history.balance = sum (E, 1) + states.D - states.W;
  inertia = sum (cellfun (@(model) model.arrays.moment_of_inertia, mechanism.models));
  history.energy_floor = energy_floor (inertia, system.duration);
  history.lambda = states.lambda;
  history.markers = marker_places (mechanism, states.q);
  history.joints = joint_forces (mechanism, at, states.lambda);
  history.residual = max ([abs(at.constraints.residual); zeros(1, numel (times))], [], 1);
  history.velocity_residual = max ([abs(at.constraints.velocity); zeros(1, numel (times))], [], 1);
  for k = 1:numel (mechanism.models)
    model = mechanism.models{k};
    index = index_of (mechanism, k);
    n = numel (index) - 3;
    q = states.q(index,:);
    body = struct ("phi", q(n+1,:), "phi_dot", states.v(index(n+1),:), "x", q(n+2,:), "y", q(n+3,:), "V", q(1:n,:));
    body.psi = model.equations.angle (model, 0, body.phi, body.V);
    body.tip_psi = model.equations.angle (model, model.length, body.phi, body.V);
    body.V_names = mode_names (model.base);
    [body.tip_x, body.tip_y] = body_centreline (model, model.length, body, 1);
    [body.mid_x, body.mid_y] = body_centreline (model, model.length/2, body, 1);
    history.bodies(k) = body;
  endfor
endfunction

%!test
%! [system, start] = sample_mechanism ([0 1]);
%! history = measure_mechanism (system, [0 1], named_rows (system, stacked_rows (start)*[1 1]));
%! assert (history.balance(1), history.balance(2), 1e-12);
%! assert (history.bodies(1).tip_x, [0.5 0.5], 0.01);
%!test # a rod that flies: kinetic energy, energy of gravity from the height, and a spring's
%! rod = struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3);
%! scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 0]), "initial", struct ("y", 5, "x_dot", 2))};
%! scene.joints = {struct("kind", "bushing", "bodies", 1, "stations", 0, "point", [1 5], "stiffness", 4)};
%! scene.duration = 1;
%! scene.gravity = 10;
%! scene = check_mechanism (scene);
%! system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%! start = struct ("q", [0; 0; 5], "v", [0; 2; 0], "lambda", zeros (0, 1), "W", 0.5, "D", 0.25);
%! history = measure_mechanism (system, 0, start);
%! assert ([history.T, history.U, history.Z, history.W, history.D], [6*2^2/2, 4*1/2, 6*10*5, 0.5, 0.25], 1e-12);
%! assert (history.balance, 12 + 2 + 300 + 0.25 - 0.5, 1e-12);
