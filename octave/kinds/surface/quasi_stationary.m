## -*- texinfo -*-
## @deftypefn {} {@var{z} =} quasi_stationary (@var{system}, @var{z}, @var{z_dot}, @var{metres})
## Coordinates near @var{z} (n-by-1) of a rod on a surface (see @code{surface_rod}) at the start, where the modes that
## would vibrate by less than so many @var{metres}, all of them together, are where they rest under the loads: no step
## has to follow them, and no method damps them.  Those of periods longer than the duration stay as they are.
## @end deftypefn

function z = quasi_stationary (system, z, z_dot, metres)
  M = system.mass_matrix (z);
  K = system.tangent_stiffness (0, z, z_dot, 0*z);
  [modes, squares] = free_modes (K, M);
  omega_2 = squares.';
  modes = modes(:,omega_2 > (2*pi/system.duration)^2);
  omega_2 = omega_2(omega_2 > (2*pi/system.duration)^2);
  shift = -(system.residual (0, z, z_dot, 0*z).'*modes)./omega_2;
  [sizes, order] = sort (cellfun (system.size, num2cell (modes.*shift, 1)));
  small = order(cumsum (sizes) <= metres)(:).';
  for pass = 1:3
    shift = -(system.residual (0, z, z_dot, 0*z).'*modes(:,small))./omega_2(small);
    z += modes(:,small)*shift.';
  endfor
endfunction

%!test # a rod that hangs is stretched by its weight from the start: rhoA g l^2/(2 EA) at its tip
%! scene = struct ("surface", struct ("name", "plane", "inclination", pi/2, "side", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 1e6, "EI", 1, "rhoA", 3), "ends", {{"hinge", "free"}}, ...
%!                 "gravity", 10, "initial", struct ("angle", -pi/2), "model", struct ("modes", [4 4]));
%! scene.solver.tolerance = 1e-2;
%! system = surface_rod (check_surface_scene (scene));
%! start = system.initial_state(1:system.n);
%! assert (system.size (start), 3*10*2^2/(2*1e6), 1e-8);
%! assert (system.residual (0, start, 0*start, 0*start), zeros (system.n, 1), 1e-8);
%! scene.solver.tolerance = 1e-4;  # a twentieth of it may be moved
%! system = surface_rod (check_surface_scene (scene));
%! assert (system.size (system.initial_state(1:system.n)) <= 5e-6);
%!test # where no mode has time to vibrate, nothing moves
%! scene = struct ("surface", struct ("name", "plane", "inclination", pi/2), "duration", 0.01, "gravity", 10, ...
%!                 "rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3), "ends", {{"hinge", "free"}}, ...
%!                 "model", struct ("modes", [4 4]));
%! system = surface_rod (check_surface_scene (scene));
%! assert (system.initial_state(1:system.n), zeros (system.n, 1));
%!test # what a load will be later is not what stretches it at the start
%! scene = struct ("surface", struct ("name", "plane", "inclination", pi/2, "side", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 1e6, "EI", 1, "rhoA", 3), "ends", {{"hinge", "free"}}, ...
%!                 "gravity", 10, "initial", struct ("angle", -pi/2), "model", struct ("modes", [4 4]));
%! scene.force = @(t) [0, 0, -1e7*t];
%! scene.solver.tolerance = 1e-2;
%! system = surface_rod (check_surface_scene (scene));
%! assert (system.size (system.initial_state(1:system.n)), 3*10*2^2/(2*1e6), 1e-8);
