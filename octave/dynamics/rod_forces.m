## -*- texinfo -*-
## @deftypefn {} {[@var{mass_V_phi}, @var{mass_phi_phi}, @var{force_V}, @var{force_phi}, @var{power}, @
##   @var{dissipated}] =} rod_forces (@var{t}, @var{phi}, @var{phi_dot}, @var{V}, @var{V_dot}, @var{c})
## Blocks of the mass matrix and generalized forces of the rod with its loads at the times @var{t} (1-by-m), from
## @code{rod_equations} and @code{rod_point_force}; @var{c} comes from @code{rod_constants}.
## @end deftypefn

function [mass_V_phi, mass_phi_phi, force_V, force_phi, power, dissipated] = rod_forces (t, phi, phi_dot, V, V_dot, c)
  [mass_V_phi, mass_phi_phi, force_V, force_phi, power, dissipated] = rod_equations (
    phi, phi_dot, V, V_dot, c.arguments{:}, c.moment (t), c.slopes{:});
  if (! isempty (c.force))
    F = at_times (c.force, t);
    [load_V, load_phi, load_power] = rod_point_force (phi, phi_dot, V, V_dot, F(1,:), F(2,:), ...
                                                      c.force_arguments{:});
    force_V += load_V;
    force_phi += load_phi;
    power += load_power;
  endif
endfunction

%!test # with the mass matrix they give the same accelerations as the rates of the hinged rod
%! scene = setfield (paper (), "force", @(t) [3 5]);
%! scene.model.stiffening = "foreshortening"; scene.model.modes = [2 3];
%! scene.rod.damping = 1e-4; scene.rod.half_height = 0.1; scene.force_station = 0.7; scene.tip_mass = 2;
%! scene.rod.lambda = 1e8; scene.rod.mu = 1e8;
%! scene = check_scene (scene);
%! model = build_model (scene, rung_of_scene (scene));
%! [system, c] = deal (hinged_rod (scene, model), rod_constants (scene, model));
%! [q, q_dot, phi, phi_dot] = deal (0.01*[1 -2 3 4 -5].', [1 2 -3 -4 5].'/10, 0.4, 5);
%! [~, p] = rod_energies_of (phi, phi_dot, q, q_dot, c);
%! y_dot = system.rate (0.1, [q; phi; q_dot; p; 0; 0], [0 0.3]);
%! [m, mm, force_V, force_phi, power, dissipated] = rod_forces (0.1, phi, phi_dot, q, q_dot, c);
%! accelerations = [c.mass_matrix, m; m.', mm] \ [force_V; force_phi];
%! assert (y_dot(6), phi_dot, 1e-12);
%! assert (y_dot(7:11), accelerations(1:5), 1e-9*norm (accelerations));
%! assert (y_dot([13 14]), [power; dissipated], 1e-9*abs (power));
