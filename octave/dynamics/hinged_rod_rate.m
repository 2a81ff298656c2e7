## -*- texinfo -*-
## @deftypefn {} {@var{y_dot} =} hinged_rod_rate (@var{t}, @var{y}, @var{interval}, @var{n}, @var{c})
## Rate of the state of @code{hinged_rod}, from @code{rod_rates}, or @code{rod_rates_with_force} in a scene with a force.
##
## Loads are taken at a time within @var{interval} = [start, end] (s), which has no jump in it.
## @end deftypefn

function y_dot = hinged_rod_rate (t, y, interval, n, c)
  V_dot = y(n+2:2*n+1);
  t = min (max (t, interval(1)), interval(2));
  if (isempty (c.force))
    [V_ddot, phi_dot, torque, power, dissipated] = rod_rates (
      y(n+1), y(2*n+2), y(1:n), V_dot, c.inverse_mass_matrix, c.arguments{:}, c.moment (t), c.slopes{:});
  else
    F = c.force (t);
    [V_ddot, phi_dot, torque, power, dissipated] = rod_rates_with_force (
      y(n+1), y(2*n+2), y(1:n), V_dot, c.inverse_mass_matrix, c.arguments{:}, c.moment (t), c.slopes{:}, ...
      F(1), F(2), c.force_arguments{:});
  endif
  y_dot = [V_dot; phi_dot; V_ddot; torque; power; dissipated];
endfunction

%!test # where the moment jumps, the interval says which value is meant
%! scene = check_scene (setfield (paper (), "model", "modes", [7 7]));
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! before = system.rate (0.3, system.initial_state, [0, 0.3 - eps]);
%! after = system.rate (0.3, system.initial_state, [0.3 1.8]);
%! assert (abs (before - after)(30), 90, 1e-9);

%!test # a force that carries the rod's weight at its middle
%! scene = setfield (paper (), "force", @(t) [0 7800*6e-4*9.81]); scene.force_station = 0.5; scene.moment = 0;
%! scene.model.modes = [0 0];
%! scene = check_scene (scene);
%! system = hinged_rod (scene, build_model (scene, rung_of_scene (scene)));
%! assert (system.rate (0, [0.3; 0; 0; 0], [0 1]), zeros (4, 1), 1e-12);
