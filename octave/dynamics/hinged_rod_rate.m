## -*- texinfo -*-
## @deftypefn {} {@var{y_dot} =} hinged_rod_rate (@var{t}, @var{y}, @var{interval}, @var{n}, @var{c})
## Rate of the state of @code{hinged_rod}.  The equations come from @code{rod_equations}; here the mass matrix, whose
## block M is constant, is eliminated by blocks.
##
## The moment is taken at a time within @var{interval} = [start, end] (s), which has no jump in it.
## @end deftypefn

function y_dot = hinged_rod_rate (t, y, interval, n, c)
  V = y(1:n);
  phi_dot = y(2*n+2);
  V_dot = y(n+2:2*n+1);
  moment = c.moment (min (max (t, interval(1)), interval(2)));

  [mass_V_phi, mass_phi_phi, force_V, force_phi, moment_power, dissipated_power] = rod_equations (
    y(n+1), phi_dot, V, V_dot, c.mass_matrix, c.gyroscopic_matrix, c.coupling_vector, c.centrifugal_vector, ...
    c.moment_of_inertia, c.stiffness_matrix, c.gravity, c.static_moment, c.first_moment_1, c.first_moment_2, ...
    c.damping, moment, c.slope_1, c.slope_2);

  solved = c.inverse_mass_matrix*[mass_V_phi, force_V];
  eliminated = mass_V_phi.'*solved;
  phi_ddot = (force_phi - eliminated(2))/(mass_phi_phi - eliminated(1));
  y_dot = [V_dot; phi_dot; solved(:,2) - phi_ddot*solved(:,1); phi_ddot; moment_power; dissipated_power];
endfunction

%!test # where the moment jumps, the interval says which value is meant
%! system = hinged_rod (scene = check_scene (paper ()), build_model (scene));
%! before = system.rate (0.3, system.initial_state, [0, 0.3 - eps]);
%! after = system.rate (0.3, system.initial_state, [0.3 1.8]);
%! assert (abs (before - after)(30) > 10);
