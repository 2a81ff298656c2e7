## -*- texinfo -*-
## @deftypefn {} {@var{momenta} =} momenta_of_rod (@var{n}, @var{c}, @var{mass}, @var{stiffness})
## The hinged rod of @var{n} coordinates in coordinates and momenta, z = (q; phi; dT/dq_dot; p; W; D), for methods that
## keep what Hamilton's equations keep: a struct of rate (t, z), state (z) = y of @code{hinged_rod},
## form (y) = z and linear, the matrix of its linear oscillation with the matrices @var{mass} and @var{stiffness}.
## @var{c} comes from @code{rod_constants}.
## @end deftypefn

function momenta = momenta_of_rod (n, c, mass, stiffness)
  momenta.rate = @(t, z) rate (t, z, n, c);
  momenta.state = @(z) state (z, n, c);
  momenta.form = @(y) form (y, n, c);
  momenta.linear = [zeros(n + 1), inv(mass); -stiffness, zeros(n + 1)];
  momenta.linear(2*n+4,2*n+4) = 0;
endfunction

function z_dot = rate (t, z, n, c)
  motion = struct ("V", z(1:n,:), "phi", z(n+1,:), "momentum_V", z(n+2:2*n+1,:), "angular_momentum", z(2*n+2,:));
  loads = loads_of_rod (t, motion, c);
  [motion.V_dot, motion.phi_dot] = rod_velocities (motion, c.rod, c.gravity, loads);
  [loads, taken, lost] = with_joints (loads, t, motion, c);
  [force_V, torque, power, dissipated] = rod_momentum_rates (motion, c.rod, c.gravity, loads);
  z_dot = [motion.V_dot; motion.phi_dot; force_V; torque; power + taken; dissipated + lost];
endfunction

function y = state (z, n, c)
  y = z;
  motion = struct ("V", z(1:n,:), "phi", z(n+1,:), "momentum_V", z(n+2:2*n+1,:), "angular_momentum", z(2*n+2,:));
  y(n+2:2*n+1,:) = rod_velocities (motion, c.rod, c.gravity, struct ("inertia", zeros (size (motion.phi))));
endfunction

function z = form (y, n, c)
  motion = struct ("V", y(1:n,:), "phi", y(n+1,:), "V_dot", y(n+2:2*n+1,:), "angular_momentum", y(2*n+2,:));
  z = y;
  z(n+2:2*n+1,:) = rod_momenta (motion, c.rod, c.gravity);
endfunction

%!function [system, y] = any_rod ()
%!  scene = setfield (paper (), "force", @(t) [3 5]);
%!  scene.model.stiffening = "foreshortening"; scene.model.modes = [2 3];
%!  scene.rod.damping = 1e-4; scene.rod.half_height = 0.1; scene.rod.lambda = 1e8; scene.rod.mu = 1e8;
%!  scene = check_scene (scene);
%!  system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%!  y = [0.01*[1 -2 3 4 -5].'; 0.4; [1 2 -3 -4 5].'/10; 30; 0; 0];
%!endfunction
%!test # there and back
%! [system, y] = any_rod ();
%! assert (system.momenta.state (system.momenta.form (y)), y, 1e-12);
%!test # the same motion as the rates of the state
%! [system, y] = any_rod ();
%! [z, h] = deal (system.momenta.form (y), 1e-6);
%! z_dot = system.momenta.rate (0.1, z);
%! moved = (system.momenta.state (z + h*z_dot) - system.momenta.state (z - h*z_dot))/(2*h);
%! y_dot = system.rate (0.1, y);
%! assert (moved, y_dot, 1e-7*norm (y_dot));
