## -*- texinfo -*-
## @deftypefn {} {@var{along} =} surface_section (@var{system}, @var{z}, @var{stations})
## Forces and moments in the sections of a rod on a surface (see @code{surface_rod}) at rest with the coordinates
## @var{z} (n-by-1), at the @var{stations} (p-by-1, m): a struct of columns (p-by-1) N and Q (N; along the rod, and
## across it in the tangent plane), M (N m; about the normal), M_normal (of bending across the tangent plane) and
## torque. What lies beyond the section does this to what lies before it.
##
## Q balances the moments about the normal: Q stretch = -M_1 - moment_coupling, M_1 the slope of the polynomial through
## the quadrature's points (see @code{slopes_of_points}).
## @end deftypefn

function along = surface_section (system, z, stations)
  at = @(stations) system.fields (0, z, 0*z, 0*z, stations);
  along = struct ("N", [], "Q", [], "M", []);
  [along.N, along.M, along.M_normal, along.torque, moment_coupling, stretch] = system.surface.section (
    at (stations), system.rod);
  [~, inside] = system.surface.section (at (system.points), system.rod);
  along.Q = -(slopes_of_points (system, stations)*inside + moment_coupling)./stretch;
endfunction

%!test # an elastica: what its end carries, turned into each section
%! scene = setfield (plane_rods ({"clamped", "free"}, [16 16]), "force", [1 2 0]);
%! scene = check_surface_scene (scene);
%! system = surface_rod (scene);
%! z = equilibrium (surface_at_rest (scene, system), 0);
%! xi = linspace (0, 1, 11).';
%! along = surface_section (system, z, xi);
%! f = system.fields (0, z, z, z, xi);
%! angle = atan2 (f.alpha2_1, f.alpha1_1);
%! assert (along.N, cos (angle) + 2*sin (angle), 1e-4);
%! assert (along.Q, 2*cos (angle) - sin (angle), 1e-4);
%! assert (along.M, (f.alpha1(end) - f.alpha1)*2 - (f.alpha2(end) - f.alpha2), 1e-6);
%!test # a helix on a cylinder that nothing loads: its couple across and its torque turn with it
%! scene = struct ("surface", struct ("name", "cylinder", "radius", 0.5), "gravity", 0, "duration", 1, ...
%!                 "rod", struct ("length", 1, "EA", 1e6, "EI", 1, "EI_normal", 2, "GJ", 5, "rhoA", 1), ...
%!                 "ends", {{"clamped", "clamped"}}, "model", struct ("modes", [10 10]));
%! scene.initial.angle = pi/6;
%! scene = check_surface_scene (scene);
%! system = surface_rod (scene);
%! z = equilibrium (surface_at_rest (scene, system), 0);
%! along = surface_section (system, z, [0.2; 0.5; 0.8]);
%! [kappa, tau] = deal (sin (pi/6)^2/0.5, sin (pi/6)*cos (pi/6)/0.5);
%! assert (along.M_normal, 2*kappa*ones (3, 1), 1e-3); assert (abs (along.torque), 5*tau*ones (3, 1), 1e-3);
%! assert (along.Q + (5 - 2)*kappa*along.torque/5, zeros (3, 1), 1e-2);
