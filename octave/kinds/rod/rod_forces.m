## -*- texinfo -*-
## @deftypefn {} {[@var{mass_V_phi}, @var{mass_phi_phi}, @var{force_V}, @var{force_phi}, @var{power}, @
##   @var{dissipated}, @var{more_power}] =} rod_forces (@var{t}, @var{phi}, @var{phi_dot}, @var{V}, @var{V_dot}, @var{c})
## Blocks of the mass matrix and generalized forces of the rod with its loads at the times @var{t} (1-by-m), from
## @code{rod_equations}; @var{c} comes from @code{rod_constants}.  The power of the loads is @var{power} +
## @var{more_power}*phi_ddot.
## @end deftypefn

function [mass_V_phi, mass_phi_phi, force_V, force_phi, power, dissipated, more_power] = rod_forces ( ...
    t, phi, phi_dot, V, V_dot, c)
  motion = struct ("phi", phi, "phi_dot", phi_dot, "V", V, "V_dot", V_dot);
  [loads, taken, lost] = with_joints (loads_of_rod (t, motion, c), t, motion, c);
  [mass_V_phi, mass_phi_phi, force_V, force_phi, power, dissipated, more_power] = rod_equations (
    motion, c.rod, c.gravity, loads);
  power += taken;
  dissipated += lost;
endfunction

%!test # with the mass matrix they give the same accelerations as the rates of the hinged rod, followers or not
%! for axial = {"dynamic", "quasistatic"}
%! scene = setfield (paper (), "force", @(t) [3 + 2e7*t, 5]);
%! scene.model.stiffening = "foreshortening"; scene.model.modes = [2 3]; scene.model.axial = axial{1};
%! scene.rod.damping = 1e-4; scene.rod.half_height = 0.1; scene.force_station = 0.7; scene.tip_mass = 2;
%! scene.rod.lambda = 1e8; scene.rod.mu = 1e8;
%! scene = check_scene (scene);
%! model = build_model (scene, rung_of_scene (scene));
%! [system, c] = deal (hinged_rod (scene, model), rod_constants (scene, model));
%! n = columns (model.basis);
%! [q, q_dot, phi, p] = deal (0.01*[3 4 -5 1 -2](1:n).', [-3 -4 5 1 2](1:n).'/10, 0.4, 60);
%! y_dot = system.rate (0.1, [q; phi; q_dot; p; 0; 0]);
%! [m, mm, force_V, force_phi, power, dissipated, more_power] = rod_forces (0.1, phi, y_dot(n+1), q, q_dot, c);
%! accelerations = [c.rod.mass_matrix, m; m.', mm] \ [force_V; force_phi];
%! assert (y_dot(n+2:2*n+1), accelerations(1:n), 1e-8*norm (accelerations));
%! assert (y_dot(2*n+[3 4]), [power + more_power*accelerations(end); dissipated], 1e-8*abs (power));
%! endfor
