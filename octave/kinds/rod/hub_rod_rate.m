## -*- texinfo -*-
## @deftypefn {} {[@var{y_dot}, @var{torque}, @var{phi_ddot}] =} hub_rod_rate (@var{t}, @var{y}, @var{n}, @var{c})
## Rates of the states @var{y} (a column a time) of @code{hub_rod} at the times @var{t} (1-by-m), and the torque of the
## hub (N m): the multiplier of the constraint that the tangent at O has the hub's angle.  The rotation phi of the
## rod's frame and its angular acceleration (rad/s^2) follow from it.
## @end deftypefn

function [y_dot, torque, phi_ddot] = hub_rod_rate (t, y, n, c)
  V = y(1:n,:);
  V_dot = y(n+1:2*n,:);
  theta = c.rotation (t);
  [phi, phi_dot, gradient, acceleration] = rod_in_hub (theta(1,:), theta(2,:), struct ("V", V, "V_dot", V_dot), c.rod);
  [mass_V_phi, mass_phi_phi, force_V, force_phi, power, dissipated, more_power] = rod_forces (
    t, phi, phi_dot, V, V_dot, c);
  [V_ddot, phi_ddot, torque] = hub_accelerations (c.rod.inverse_mass_matrix, mass_V_phi, mass_phi_phi, gradient, ...
                                                  force_V, force_phi, theta(3,:) - acceleration);
  y_dot = [V_dot; V_ddot; power + more_power.*phi_ddot + torque.*theta(2,:); dissipated];
endfunction

%!test # a rigid rod: the torque turns its moment of inertia and carries its weight
%! scene = setfield (spin_up (), "gravity", 9.81); scene.rotation = @(t) [t^2, 2*t, 2]; scene.model.modes = [0 0];
%! scene = check_scene (scene);
%! model = build_model (scene, rung_of_scene (scene));
%! system = hub_rod (scene, model);
%! [y_dot, torque] = system.rate (0.5, [0; 0]);
%! assert (torque, 2*model.arrays.moment_of_inertia + 1.2*9.81*50*cos (0.25), 1e-9);
%! assert (y_dot(1), torque*1, 1e-9);
