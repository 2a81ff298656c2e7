## -*- texinfo -*-
## @deftypefn {} {@var{C} =} tangent_damping (@var{system}, @var{t}, @var{z}, @var{z_dot}, @var{z_ddot})
## Derivative of the residual of a rod on a surface (see @code{surface_rod}) by z_dot at k times and states (n-by-k
## each): n-by-n-by-k, N s per unit of z, all columns in one call (see @code{imaginary_steps}).
## @end deftypefn

function C = tangent_damping (system, t, z, z_dot, z_ddot)
  C = imaginary_steps (@(t, step, z, z_dot, z_ddot) system.residual (t, z, z_dot + step, z_ddot), ...
                       1e-30*system.points(end), t, z, z_dot, z_ddot);
endfunction

%!test # of a stretched rod with Kelvin and Voigt's damping it is the stiffness times that time, and a damper's
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1, "damping", 0.1), ...
%!                 "model", struct ("modes", [3 3]));
%! [z, v] = deal (zeros (6, 1));
%! system = surface_rod (check_surface_scene (scene));
%! assert (tangent_damping (system, 0, z, v, z), 0.1*tangent_stiffness (system, 0, z, v, z), 1e-13);
%! damper = struct ("kind", "spring", "stations", 2, "point", [5 0 0], "damping", 0.7);
%! both = surface_rod (check_surface_scene (setfield (scene, "joints", {damper})));
%! assert ((tangent_damping (both, 0, z, v, z) - tangent_damping (system, 0, z, v, z))(1,1), 0.7, 1e-12);
