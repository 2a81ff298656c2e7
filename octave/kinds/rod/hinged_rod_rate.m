## -*- texinfo -*-
## @deftypefn {} {[@var{y_dot}, @var{phi_ddot}] =} hinged_rod_rate (@var{t}, @var{y}, @var{n}, @var{c})
## Rates of the states @var{y} (a column a time) of @code{hinged_rod} at the times @var{t} (1-by-m), and the angular
## acceleration of the rod's frame (rad/s^2), from @code{rod_rates}; joints' forces depend on the rate of the rotation,
## from @code{rod_turning}.
## @end deftypefn

function [y_dot, phi_ddot] = hinged_rod_rate (t, y, n, c)
  motion.V = y(1:n,:);
  motion.phi = y(n+1,:);
  motion.V_dot = y(n+2:2*n+1,:);
  motion.angular_momentum = y(2*n+2,:);
  loads = loads_of_rod (t, motion, c);
  taken = lost = 0;
  if (! isempty (c.joined))
    motion.phi_dot = rod_turning (motion, c.rod, c.gravity, loads);
    [loads, taken, lost] = with_joints (loads, t, motion, c);
  endif
  [V_ddot, phi_dot, torque, power, dissipated, phi_ddot] = rod_rates (motion, c.rod, c.gravity, loads);
  y_dot = [motion.V_dot; phi_dot; V_ddot; torque; power + taken; dissipated + lost];
endfunction

%!test # a force that carries the rod's weight at its middle
%! scene = setfield (paper (), "force", @(t) [0 7800*6e-4*9.81]); scene.force_station = 0.5; scene.moment = 0;
%! scene.model.modes = [0 0];
%! scene = check_scene (scene);
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! assert (system.rate (0, [0.3; 0; 0; 0]), zeros (4, 1), 1e-12);

%!test # at several times at once it is what it is at each
%! scene = setfield (paper (), "force", @(t) [t, 5]); scene.model.modes = [2 3]; scene.rod.damping = 1e-4;
%! scene = check_scene (scene);
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! y = 1e-3*reshape (1:42, 14, 3);
%! together = system.rate ([0 0.1 0.2], y);
%! for k = 1:3
%!   assert (together(:,k), system.rate ((k - 1)/10, y(:,k)), 1e-12*norm (together(:,k)));
%! endfor
