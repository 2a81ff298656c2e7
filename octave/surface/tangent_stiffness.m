## -*- texinfo -*-
## @deftypefn {} {@var{K} =} tangent_stiffness (@var{system}, @var{t}, @var{z}, @var{z_dot}, @var{z_ddot})
## Derivative of the residual of a rod on a surface (see @code{surface_rod}) by z (n-by-n, N per unit of z), by central
## differences: all columns in one call.
## @end deftypefn

function K = tangent_stiffness (system, t, z, z_dot, z_ddot)
  n = system.n;
  h = 1e-5*system.points(end);
  step = full (h*eye (n));
  R = system.residual (t, [z + step, z - step], repmat (z_dot, 1, 2*n), repmat (z_ddot, 1, 2*n));
  K = (R(:,1:n) - R(:,n+1:end))/(2*h);
endfunction

%!test # of a rod that is stretched on the plane: EA/l in the first polynomial, by 2/l squared
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1), "model", struct ("modes", [3 3]));
%! system = surface_rod (check_surface_scene (scene));
%! K = tangent_stiffness (system, 0, zeros (6, 1), zeros (6, 1), zeros (6, 1));
%! assert (K(2,2), 3*2, 1e-6);
%! assert (K, K.', 1e-6);
