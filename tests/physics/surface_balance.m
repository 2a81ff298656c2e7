## -*- texinfo -*-
## @deftypefn {} {[@var{power}, @var{rate}] =} surface_balance (@var{system}, @var{t})
## The balance of a rod on a surface (see @code{surface_rod}) at the time @var{t} (s) in a random state: the
## @var{power} (W) of what its forces leave over, of its loads and hub, less what is dissipated, and the @var{rate} of
## its energies, by differences of the fourth order.
## @end deftypefn

function [power, rate] = surface_balance (system, t)
  rand ("seed", 1);
  [z, z_dot, z_ddot] = deal (0.1*rand (system.n, 1), rand (system.n, 1), rand (system.n, 1));
  h = 1e-4;
  E = @(s) sum (surface_energies (system, t + s, z + s*z_dot + s^2/2*z_ddot, z_dot + s*z_ddot)(1:3,:), 1);
  rate = (8*(E (h) - E (-h)) - (E (2*h) - E (-2*h)))/(12*h);
  power = z_dot.'*system.residual (t, z, z_dot, z_ddot) + [1 -1]*system.power (t, z, z_dot, z_ddot);
endfunction

%!test # with all that acts on a rod on a surface
%! [power, rate] = surface_balance (surface_rod (torus_pendulum ()), 0);
%! assert (power, rate, 1e-7*abs (rate));
%!test # and of a rod in a hub, what that does beside: on a plane, and on a sphere
%! for surface = {struct("name", "plane", "inclination", 0.7), struct("name", "sphere", "radius", 2)}
%!   scene = struct ("surface", surface{1}, "duration", 1, "ends", {{"clamped", "free"}}, "tip_mass", 0.3, ...
%!                   "model", struct ("modes", [4 5]), "force", [1 2 3], ...
%!                   "rotation", @(t) [0.3*t^2 + t, 0.6*t + 1, 0.6]);
%!   scene.rod = struct ("length", 1, "EA", 100, "EI", 0.1, "GJ", 0.3, "rhoA", 2, "rhoI", 0.4, "damping", 0.2);
%!   scene.joints = {struct("kind", "spring", "stations", 0.6, "point", [1 2 3], "stiffness", 5, "damping", 1)};
%!   [power, rate] = surface_balance (surface_rod (check_surface_scene (scene)), 0.5);
%!   assert (power, rate, 1e-7*abs (rate));
%! endfor
