## -*- texinfo -*-
## @deftypefn {} {@var{system} =} with_dropped (@var{scene}, @var{model})
## The system of @code{rod_system} with the forces of what the @var{model} of a straight rod drops (see
## @code{dropped_forces}), taken along its own motion: how its motion differs is, to the first order, the model's error
## against the geometrically exact rod.  Those forces and accelerations feel each other (see
## @code{accelerations_with_dropped}), much where modes along the rod are as fast as what bends it.  In a hub the
## tangent at O has the angle that its slope really has.  Work and dissipated energy are left at 0.
## @end deftypefn

function system = with_dropped (scene, model)
  system = rod_system (scene, model);
  constants = rod_constants (scene, model);
  constants.points = dropped_points (model, scene);
  constants.followers = model.followers;
  constants.tangent = ! strcmp (scene.model.moment_work, "chord");
  n = columns (model.basis);
  if (isempty (scene.rotation))
    bare = system.rate;
    system.rate = @(t, y) hinged (t, y, n, bare (t, y), constants);
  else
    motion = system.motion;
    system.rate = @(t, y) in_hub (t, y, n, constants);
    system.motion = @(times, states) without_angle (motion (times, states), constants);
  endif
endfunction

function y_dot = hinged (t, y, n, y_dot, c)
  q = y(1:n,:);
  q_dot = y(n+2:2*n+1,:);
  phi = y(n+1,:);
  phi_dot = y_dot(n+1,:);
  [mass_q_phi, mass_phi_phi, force_q, force_phi] = rod_forces (t, phi, phi_dot, q, q_dot, c);
  solved = @(f, g) rod_accelerations (c.rod, mass_q_phi, mass_phi_phi, force_q + f, force_phi + g);
  [q_ddot, torque] = accelerations_with_dropped (solved, t, q, q_dot, phi, phi_dot, c);
  y_dot(n+2:2*n+1,:) = q_ddot;
  y_dot(2*n+2,:) += torque;
  y_dot(2*n+3:end,:) = 0;
endfunction

function y_dot = in_hub (t, y, n, c)
  q = y(1:n,:);
  q_dot = y(n+1:2*n,:);
  theta = c.rotation (t);
  [phi, phi_dot, gradient, acceleration] = rod_in_hub (theta(1,:), theta(2,:), struct ("V", q, "V_dot", q_dot), c.rod);
  [angle, angle_dot, by_slope, by_stretch, second_rate] = angle_at_O (q, q_dot, c.points);
  phi -= angle;
  phi_dot -= angle_dot;
  gradient += c.points.slope_at_O.'*by_slope + c.points.stretch_at_O.'*by_stretch;
  right_side = theta(3,:) - acceleration - second_rate;
  [mass_q_phi, mass_phi_phi, force_q, force_phi] = rod_forces (t, phi, phi_dot, q, q_dot, c);
  solved = @(f, g) hub_accelerations (c.rod.inverse_mass_matrix, mass_q_phi, mass_phi_phi, gradient, force_q + f, ...
                                      force_phi + g, right_side);
  q_ddot = accelerations_with_dropped (solved, t, q, q_dot, phi, phi_dot, c);
  y_dot = [q_dot; q_ddot; zeros(2, columns (q))];
endfunction

function varargout = angle_at_O (q, q_dot, points)
  b = points.slope_at_O;
  a = points.stretch_at_O;
  [varargout{1:nargout}] = rod_dropped_angle (b*q, b*q_dot, a*q, a*q_dot);
endfunction

## the chord is behind the tangent, which the hub turns, by the angle that the slope at O really has
function found = without_angle (found, c)
  [angle, angle_dot] = angle_at_O (found.q, found.q_dot, c.points);
  found.phi -= angle;
  found.phi_dot -= angle_dot;
endfunction

%!test # a quarter of the pendulum's shape in weightless rest: nothing moves, with or without
%! scene = setfield (setfield (paper (), "gravity", 0), "moment", 0); scene.moment_breaks = [];
%! scene.model = struct ("modes", [0 2], "stiffening", "foreshortening");
%! scene = check_scene (scene);
%! system = with_dropped (scene, build_model (scene, rung_of_scene (scene)));
%! assert (system.rate ([0 1], system.initial_state(:,[1 1])), zeros (8, 2), 1e-12);
%!test # in a hub the tangent at O has its angle: asin of the slope, and the stretch
%! scene = setfield (spin_up (), "duration", 2);
%! scene.model = struct ("modes", [0 3], "stiffening", "foreshortening", "moment_work", "chord");
%! scene = check_scene (scene);
%! model = build_model (scene, rung_of_scene (scene));
%! system = with_dropped (scene, model);
%! y = [0.3; 0.02; -0.01; 0; 0; 0; 0; 0];
%! slope = model.arrays.slope_2.'*y(1:3);
%! assert (system.motion (1.5, y).phi + asin (slope), scene.rotation (1.5)(1), 0.5*slope^5);
%! scene.model.moment_work = "tangent";  # which a hub holds, whatever a moment would work on
%! assert (with_dropped (scene, model).rate (1.5, y), system.rate (1.5, y));
%!function phi = behind (scene, q)   # of the chord, where a hub has not turned
%!  scene = check_scene (setfield (scene, "rotation", @(t) [0 0 0]));
%!  system = with_dropped (scene, build_model (scene, rung_of_scene (scene)));
%!  phi = system.motion (1, [q; zeros(numel (q) + 2, 1)]).phi;
%!endfunction
%!function q_ddot = in_a_hub (scene, q, phi, theta_ddot)   # from rest
%!  theta = phi - behind (scene, q);
%!  turn = @(t) [theta + theta_ddot*(t - 1)^2/2, theta_ddot*(t - 1), theta_ddot];
%!  scene = check_scene (setfield (scene, "rotation", turn));
%!  rate = with_dropped (scene, build_model (scene, rung_of_scene (scene))).rate;
%!  q_ddot = rate (1, [q; zeros(numel (q) + 2, 1)])(numel (q)+1:2*numel (q));
%!endfunction
%!test # a moment and weight, in balance but for what is dropped: as in a hub that begins to turn likewise
%! scene = setfield (setfield (rmfield (spin_up (), {"rotation", "moment_breaks"}), "gravity", 0.2), "duration", 2);
%! scene.model = struct ("modes", [0 3], "stiffening", "foreshortening");
%! hinged = check_scene (setfield (scene, "moment", @(t) 12*cos (0.3) + 0*t));
%! model = build_model (hinged, rung_of_scene (hinged));
%! rates = @(system, x) system.rate (1, [x; zeros(6, 1)])(5:8);
%! x = fsolve (@(x) rates (rod_system (hinged, model), x), [0; 0; 0; 0.3]);
%! [q, phi] = deal (x(1:3), x(4));
%! found = rates (with_dropped (hinged, model), x);
%! q_ddot = found(1:3);
%! steady = in_a_hub (scene, q, phi, 0);
%! by_turning = in_a_hub (scene, q, phi, 1) - steady;
%! theta_ddot = by_turning \ (q_ddot - steady);
%! assert (in_a_hub (scene, q, phi, theta_ddot), q_ddot, 1e-8*norm (q_ddot));
%! phi_ddot = theta_ddot + (behind (scene, q + q_ddot) - behind (scene, q - q_ddot))/2;
%! [mass_q_phi, mass_phi_phi] = rod_forces (1, phi, 0, q, 0*q, rod_constants (hinged, model));
%! assert (found(4), mass_q_phi.'*q_ddot + mass_phi_phi*phi_ddot, 1e-6*abs (mass_phi_phi*phi_ddot));
