## -*- texinfo -*-
## @deftypefn {} {@var{momenta} =} momenta_of_rod (@var{n}, @var{c}, @var{mass}, @var{stiffness})
## The hinged rod of @var{n} coordinates in coordinates and momenta, z = (q; phi; dT/dq_dot; p; W; D), for methods that
## keep what Hamilton's equations keep: a struct of rate (t, z, interval), state (z) = y of @code{hinged_rod},
## form (y) = z and linear, the matrix of its linear oscillation with the matrices @var{mass} and @var{stiffness}.
## @var{c} comes from @code{rod_constants}.
## @end deftypefn

function momenta = momenta_of_rod (n, c, mass, stiffness)
  c.velocity_arguments = [{c.inverse_mass_matrix}, c.energy_arguments];
  momenta.rate = @(t, z, interval) rate (t, z, interval, n, c);
  momenta.state = @(z) state (z, n, c);
  momenta.form = @(y) form (y, n, c);
  momenta.linear = [zeros(n + 1), inv(mass); -stiffness, zeros(n + 1)];
  momenta.linear(2*n+4,2*n+4) = 0;
endfunction

function z_dot = rate (t, z, interval, n, c)
  V = z(1:n,:);
  phi = z(n+1,:);
  t = min (max (t, interval(1)), interval(2));
  [V_dot, phi_dot] = rod_velocities (phi, z(2*n+2,:), V, z(n+2:2*n+1,:), c.velocity_arguments{:});
  [force_V, torque, power, dissipated] = rod_momentum_rates (phi, phi_dot, V, V_dot, c.arguments{:}, ...
                                                             c.moment (t), c.slopes{:});
  if (! isempty (c.force))
    F = num2cell (force_at (t, c), 2);
    [load_V, load_phi, load_power] = rod_point_force (phi, phi_dot, V, V_dot, c.energy_arguments{8}, F{:}, ...
                                                      c.force_arguments{:});
    force_V += load_V;
    torque += load_phi;
    power += load_power;
  endif
  z_dot = [V_dot; phi_dot; force_V; torque; power; dissipated];
endfunction

function y = state (z, n, c)
  y = z;
  y(n+2:2*n+1,:) = rod_velocities (z(n+1,:), z(2*n+2,:), z(1:n,:), z(n+2:2*n+1,:), c.velocity_arguments{:});
endfunction

function z = form (y, n, c)
  V = y(1:n,:);
  phi = y(n+1,:);
  V_dot = y(n+2:2*n+1,:);
  no_moment = zeros (size (phi));
  [~, phi_dot] = rod_rates (phi, y(2*n+2,:), V, V_dot, c.inverse_mass_matrix, c.arguments{:}, no_moment, c.slopes{:});
  mass_V_phi = rod_equations (phi, phi_dot, V, V_dot, c.arguments{:}, no_moment, c.slopes{:});
  z = y;
  z(n+2:2*n+1,:) = c.mass_matrix*V_dot + mass_V_phi.*phi_dot;
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
%! z_dot = system.momenta.rate (0.1, z, [0 0.3]);
%! moved = (system.momenta.state (z + h*z_dot) - system.momenta.state (z - h*z_dot))/(2*h);
%! y_dot = system.rate (0.1, y, [0 0.3]);
%! assert (moved, y_dot, 1e-7*norm (y_dot));
