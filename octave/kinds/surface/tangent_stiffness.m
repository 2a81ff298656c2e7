## -*- texinfo -*-
## @deftypefn {} {@var{K} =} tangent_stiffness (@var{system}, @var{t}, @var{z}, @var{z_dot}, @var{z_ddot})
## Derivative of the residual of a rod on a surface (see @code{surface_rod}) by z at k times and states (n-by-k each):
## n-by-n-by-k, N per unit of z, all columns in one call.
## See @code{imaginary_steps}; a surface of one's own writes abs (x) as sqrt (x^2).
## @end deftypefn

function K = tangent_stiffness (system, t, z, z_dot, z_ddot)
  K = imaginary_steps (@(t, step, z, z_dot, z_ddot) system.residual (t, z + step, z_dot, z_ddot), ...
                       1e-30*system.points(end), t, z, z_dot, z_ddot);
endfunction

%!test # of a rod that is stretched on the plane: EA/l in the first polynomial, by 2/l squared
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1), "model", struct ("modes", [3 3]));
%! system = surface_rod (check_surface_scene (scene));
%! K = tangent_stiffness (system, 0, zeros (6, 1), zeros (6, 1), zeros (6, 1));
%! assert (K(2,2), 3*2, 1e-13);
%! assert (K, K.', 1e-13);

%!test # two states at once
%! scene = struct ("surface", struct ("name", "sphere", "radius", 1), "duration", 1, "force", @(t) [t 0 0], ...
%!                 "rod", struct ("length", 1, "EA", 3, "EI", 1, "rhoA", 1), "model", struct ("modes", [3 3]));
%! system = surface_rod (check_surface_scene (scene));
%! z = [0.1; 0.2; 0; 0; 0.1; 0]*[0 1];
%! K = tangent_stiffness (system, [0 1], z, z, 2*z);
%! assert (size (K), [6 6 2]);
%! assert (K(:,:,2), tangent_stiffness (system, 1, z(:,2), z(:,2), 2*z(:,2)), 1e-13);

%!function omega = frequencies_on_sphere (N)   # of a free rod on a great circle, 1 rad of it
%!  scene = struct ("surface", struct ("name", "sphere", "radius", 0.7), "duration", 1, "gravity", 0, ...
%!                  "rod", struct ("length", 0.7, "EA", 1, "EI", 0.1, "EI_normal", 0, "rhoA", 3));
%!  scene.model.modes = [N N];
%!  system = surface_rod (check_surface_scene (scene));
%!  omega = sqrt (sort (real (eig (system.stiffness, system.mass))));
%!endfunction
%!test # frequency of the first bending on a sphere, whatever the number of polynomials: EI L^2 v = rhoA omega^2 v
%! # where L v = v'' + v/R^2, with L v = (L v)' = 0 at free ends: k_1 tan (k_1 l/2) + k_2 tanh (k_2 l/2) = 0 for even v
%! k_1 = @(W) sqrt (W + 1); k_2 = @(W) sqrt (W - 1);  # W = omega R^2 sqrt (rhoA/EI), l = R
%! W = fzero (@(W) k_1 (W)*tan (k_1 (W)/2) + k_2 (W)*tanh (k_2 (W)/2), [20 25], optimset ("TolX", 1e-14));
%! exact = W*sqrt (0.1/3)/0.7^2;
%! for N = [12 16 20]
%!   omega = frequencies_on_sphere (N);  # of stretching, too
%!   [~, nearest] = min (abs (omega - exact));
%!   assert (omega(nearest), exact, 1e-10*exact);
%! endfor
