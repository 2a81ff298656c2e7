## -*- texinfo -*-
## @deftypefn {} {@var{frequencies} =} curved_frequencies (@var{degrees}, @var{slenderness}, @var{ends}, @var{N})
## omega R^2 sqrt (rhoA/EI) of a circular arc of so many @var{degrees}, R/r = @var{slenderness} (r: the
## section's radius of inertia), with N + N base functions; the @var{ends} are "ring" (closed and free),
## "hinged" (both) or "free".
##
## The arc is free to turn and shift here: rigid motions are added to the base, the ends' constraints take them away.
## @end deftypefn

function frequencies = curved_frequencies (degrees, slenderness, ends, N)
  angle = deg2rad (degrees);
  rod = struct ("length", angle, "curvature", 1, "EA", slenderness^2, "EI", 1, "rhoA", 1);  # R = 1
  scene = check_scene (struct ("rod", rod, "duration", 1));
  base = base_functions (1:N, [1:N, -1, -2], angle);  # ends may bear moments
  axis = rod_axis (scene.rod, 32);
  section = struct ("rhoA", 1, "rhoI", 0, "EA", slenderness^2, "EI", 1);
  a = curved_arrays (base, axis, section, []);
  [M, K, at_0, at_l] = with_rigid_motions (a, base, axis);
  constraints = struct ("free", zeros (0, rows (M)), "hinged", [at_0(1:2,:); at_l(1:2,:)], "ring", at_l - at_0).(ends);
  Z = null (constraints);
  squares = sort (real (eig (Z.'*K*Z, Z.'*M*Z)));
  frequencies = sqrt (max (squares, 0));
endfunction

## coordinates: base functions, rotation, x, y; rows at the ends: u_1, u_2, turning of the tangent
function [M, K, at_0, at_l] = with_rigid_motions (a, base, axis)
  n = rows (a.mass_matrix);
  m = sum (axis.weights);
  M = [a.mass_matrix, a.coupling_vector, a.first_moment_1, a.first_moment_2
       a.coupling_vector.', a.moment_of_inertia, -axis.y*axis.weights.', axis.x*axis.weights.'
       a.first_moment_1.', -axis.y*axis.weights.', m, 0
       a.first_moment_2.', axis.x*axis.weights.', 0, m];
  K = blkdiag (a.stiffness_matrix, zeros (3));
  function rows_at = at (station)
    f = curved_functions (base, axis, station);
    [x, y] = undeformed_places (struct ("axis", axis), station);
    rows_at = [f.u_1, -y, 1, 0; f.u_2, x, 0, 1; f.chi, 1, 0, 0];
  endfunction
  at_0 = at (0);
  at_l = at (base.length);
endfunction

%!test # free inextensional ring: n (n^2 - 1)/sqrt (n^2 + 1), each twice
%! f = curved_frequencies (360, 400, "ring", 40);
%! f = f(f > 0.1)(1:6);
%! n = [2 3 4];
%! expected = n.*(n.^2 - 1)./sqrt (n.^2 + 1);
%! assert (f.', expected([1 1 2 2 3 3]), -1e-3);
%!test # circular arcs, both ends hinged, R/r = 100
%! assert (curved_frequencies (90, 100, "hinged", 20)(1), 13.755, -1e-4);
%! assert (curved_frequencies (180, 100, "hinged", 20)(1), 2.2661, -1e-4);
%!function omega = by_ritz (degrees, slenderness)   # displacements by polynomials, textbook strains: u' - w, u' + w''
%!  angle = deg2rad (degrees);
%!  [s, weights] = gauss_rule (40);
%!  [s, W] = deal (angle*s.', diag (angle*weights));
%!  [P, dP, ddP] = legendre_functions (16, s, angle);
%!  [b, db] = deal (s.*(angle - s), angle - 2*s);  # 0 at the hinges
%!  [f, df, ddf] = deal (b.*P, db.*P + b.*dP, -2*P + 2*db.*dP + b.*ddP);
%!  [stretching, bending] = deal ([df, -f], [df, ddf]);
%!  K = slenderness^2*stretching.'*W*stretching + bending.'*W*bending;
%!  omega = sqrt (min (real (eig (K, blkdiag (f.'*W*f, f.'*W*f)))));
%!endfunction
%!test # thick arcs, too, as an independent method has them
%! for slenderness = [20 100]
%!   for degrees = [90 180]
%!     assert (curved_frequencies (degrees, slenderness, "hinged", 20)(1), by_ritz (degrees, slenderness), -1e-3);
%!   endfor
%! endfor
%!test # no locking: few base functions are as good for any slenderness
%! for slenderness = [20 100 1000]
%!   few = curved_frequencies (90, slenderness, "hinged", 6)(1);
%!   assert (few, curved_frequencies (90, slenderness, "hinged", 20)(1), -1e-3);
%! endfor
%!test # curvature to 0: the straight rod's frequency, and the difference falls as the square of the angle
%! beta = 4.730041;  # free and free
%! lowest = @(degrees) curved_frequencies (degrees, 1e3/deg2rad (degrees), "free", 10)(4)*deg2rad (degrees)^2;
%! assert (lowest (1), beta^2, -1e-3);
%! assert ((lowest (20) - lowest (1))/(lowest (10) - lowest (1)), 4, 0.2);
%!function f = hung_semicircle (scene)   # Hz, with so little weight that the linear theory holds
%!  evalc ("rows = natural_modes (scene, 'output', '');");
%!  f = [rows(1:6).f];
%!endfunction
%!test # with a tip mass those of the geometrically exact rod on a plane, and of a mechanism's body
%! scene = struct ("rod", arc_pendulum ().rod, "tip_mass", 0.2, "gravity", 0.2, "duration", 1);
%! scene.model = struct ("modes", [10 20], "energy", "uniaxial");
%! checked = check_scene (scene);
%! section = rod_section (checked.rod, checked.model);
%! plane = struct ("tip_mass", 0.2, "gravity", 0.2, "duration", 1, "ends", {{"hinge", "free"}});
%! plane.surface = struct ("name", "plane", "inclination", pi/2);
%! plane.rod = struct ("length", scene.rod.length, "curvature", scene.rod.curvature, "EA", section.EA, ...
%!                     "EI", section.EI, "rhoA", section.rhoA, "rhoI", section.rhoI);
%! plane.initial.angle = -0.5;
%! plane.model.modes = [18 18];
%! of_rod = hung_semicircle (scene);
%! assert (of_rod, hung_semicircle (plane), -1e-3);
%! assert (abs (hung_semicircle (setfield (scene, "tip_mass", 0))(2:4)./of_rod(2:4) - 1) > 0.05);
%! body = struct ("rod", scene.rod, "tip_mass", 0.2, "model", scene.model);
%! hung = struct ("bodies", {{body}}, "duration", 1, "gravity", 0.2);
%! hung.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%! assert (hung_semicircle (hung), of_rod, -1e-6);
