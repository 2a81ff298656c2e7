## -*- texinfo -*-
## @deftypefn {} {@var{K} =} tangent_stiffness (@var{system}, @var{t}, @var{z}, @var{z_dot}, @var{z_ddot})
## Derivative of the residual of a rod on a surface (see @code{surface_rod}) by z at k times and states (n-by-k each):
## n-by-n-by-k, N per unit of z.
##
## What acts at a place of the rod depends on the chart's coordinates there and their first and second derivatives
## alone: it is derived by these six, by imaginary steps (see @code{imaginary_steps}) in one call; a surface of one's
## own writes abs (x) as sqrt (x^2).
## @end deftypefn

function K = tangent_stiffness (system, t, z, z_dot, z_ddot)
  K = 0;
  alone = system;
  alone.parts = system.parts([]);
  alone.loads.values = {};
  alone.springs.stiffness = [];
  for part = system.parts
    of = @(base) setfield (alone, "parts", setfield (part, "base", base));
    K += by_places (of, part.base, system.points(end), t, z, z_dot, z_ddot);
  endfor
  for kind = {"loads", "springs"}
    if (! isempty (system.(kind{1}).stations))
      of = @(base) setfield (alone, kind{1}, setfield (system.(kind{1}), "base", base));
      K += by_places (of, system.(kind{1}).base, system.points(end), t, z, z_dot, z_ddot);
    endif
  endfor
endfunction

## of (base) is the system of what acts on that base
function K = by_places (of, base, length, t, z, z_dot, z_ddot)
  [n, k] = size (z);
  step = 1e-30*length;
  stepped = setfield (base, "onto", {1, 1, 1});  # what acts at each place stays there
  steps = 1i*step*kron (eye (6), ones (1, k));
  for i = 1:2
    stepped.start_values{i} = base.start_values{i} + steps(i,:);
    stepped.start_slopes{i} = base.start_slopes{i} + steps(i+2,:);
    stepped.start_seconds{i} = base.start_seconds{i} + steps(i+4,:);
  endfor
  every = repmat (1:k, 1, 6);
  D = imag (surface_residual (of (stepped), t, z(:,every), z_dot(:,every), z_ddot(:,every)))/step;
  [works, places] = deal (rows (D), rows (base.kappa));
  row = (1:works).' + works*(every - 1);
  column = repmat ((1:places).', works/places, 1) + places*kron (0:5, ones (1, k));
  D = sparse (row, column, D, works*k, 6*places)*vertcat (base.values{:}, base.slopes{:}, base.seconds{:});
  K = permute (reshape (base.onto{works/places/2}*reshape (D, works, []), n, k, n), [1 3 2]);
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
%!test # it is the derivative of the whole residual, of all that acts, on every chart, in a hub and where that moves
%! spring = struct ("kind", "spring", "stations", {0.7, 2}, "point", {[1 2 3], [4 1 1]}, "stiffness", 4, "damping", 0.3);
%! hub = {"rotation", @(t) [0.3*t^2 + t, 0.6*t + 1, 0.6]};
%! moving = [hub, {"place", @(t) [t^2, t; 2*t, 1; 2, 0]}];
%! for surface = {struct("name", "plane", "inclination", 0.7), struct("name", "sphere", "radius", 2)}
%!   for motion = {{}, hub, moving}(1:2 + strcmp (surface{1}.name, "plane"))
%!     scene = on_level_plane ("surface", surface{1}, "ends", {{"clamped", "free"}}, "tip_mass", 0.3, "moment", 2, ...
%!                             "force", @(t) [t 1 0], "joints", {num2cell(spring)}, motion{1}{:});
%!     [scene.rod.rhoI, scene.rod.damping] = deal (0.4, 0.02);
%!     system = surface_rod (check_surface_scene (scene));
%!     [z, v, a] = deal (0.1*sin ((1:system.n).'*[1 2]), cos ((1:system.n).'*[3 1]), sin ((1:system.n).'*[4 5]));
%!     moved = @(t, step, z, v, a) system.residual (t, z + step, v, a);
%!     assert (tangent_stiffness (system, [0.1 0.4], z, v, a), imaginary_steps (moved, 1e-30, [0.1 0.4], z, v, a), 1e-10);
%!   endfor
%! endfor
