## -*- texinfo -*-
## @deftypefn {} {@var{reaction} =} normal_reaction (@var{system}, @var{t}, @var{z}, @var{z_dot})
## What the surface does to the rod of @code{surface_rod}: force per length along the normal (N/m, positive where it
## pushes to the normal's side) at the quadrature's points (p-by-m, at the m times @var{t} and states).
## Derivatives along the rod are those of the polynomials through these points' values (see @code{slopes_of_points}).
## @end deftypefn

function reaction = normal_reaction (system, t, z, z_dot)
  fields = system.fields (t, z, z_dot, z_dot, system.points);
  [parts{1:3}] = system.surface.reaction (fields, system.rod, system.gravity);
  if (system.rod.damping > 0)
    [damped{1:3}] = system.surface.damped_reaction (fields, system.rod);
    parts = cellfun (@plus, parts, damped, "uniformoutput", false);
  endif
  derivative = slopes_of_points (system, system.points);
  reaction = parts{1} - derivative*(parts{2} - derivative*parts{3});
endfunction

%!test # a rod at rest along the lowest ruling of a cylinder is carried, one that moves there is, too
%! scene = struct ("surface", struct ("name", "cylinder", "radius", 1), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 100, "EI", 1, "rhoA", 1.5), "model", struct ("modes", [5 5]));
%! scene.initial.velocity = @(xi, alpha) [0*xi; 3 + 0*xi];
%! system = surface_rod (check_surface_scene (scene));
%! n = system.n;
%! z = zeros (n, 1);
%! assert (normal_reaction (system, 0, z, z), 1.5*9.81*ones (rows (system.points), 1), 1e-8);
%! v = system.initial_state(n+1:2*n);
%! assert (normal_reaction (system, 0, z, v), 1.5*(9.81 + 9)*ones (rows (system.points), 1), 1e-8);
%!function slopes = legendre_slopes (n, xi)
%!  [~, slopes] = legendre_functions (n, xi, 1);
%!endfunction

%!test # a rod that rests in a hollow: the reaction, and what its ends are held with, carry its weight
%! surface = struct ("name", "bumps", "height", 0.1, "wave_number_1", 1, "wave_number_2", 1.5);
%! rod = struct ("length", 1, "EA", 1e3, "EI", 0.5, "EI_normal", 2, "GJ", 1, "rhoA", 1.5);
%! scene = struct ("surface", surface, "duration", 1, "rod", rod, "model", struct ("modes", [16 16]));
%! scene.initial.shape = @(xi) [0.8*(xi - 0.5); 0.6*(xi - 0.5)];
%! scene = check_surface_scene (scene);
%! system = surface_rod (scene);
%! z = equilibrium (surface_at_rest (scene, system), 0);
%! f = system.fields (0, z, z, z, system.points);
%! [f.alpha1_dot, f.alpha2_dot] = deal (0*f.alpha1_dot);
%! [~, ~, n_3] = system.surface.normal (f);
%! [parts{1:3}] = system.surface.reaction (f, system.rod, system.gravity);
%! fit = legendre_functions (30, system.points, 1);
%! [ends, slopes] = legendre_functions (30, [0; 1], 1);
%! at = @(base, value) base*(fit \ value);
%! held = at (ends, parts{2} - at (legendre_slopes (30, system.points), parts{3})).*at (ends, n_3) ...
%!        + at (ends, parts{3}).*at (slopes, n_3);
%! r = normal_reaction (system, 0, z, 0*z);
%! assert (system.weights.'*(r.*n_3) + held(2) - held(1), 1.5*9.81, 1e-4);
