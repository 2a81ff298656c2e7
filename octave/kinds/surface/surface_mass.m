## -*- texinfo -*-
## @deftypefn {} {@var{M} =} surface_mass (@var{system}, @var{z})
## The mass matrix of a rod on a surface (see @code{surface_rod}) at the places @var{z} (n-by-m): n-by-n-by-m.
## @end deftypefn

function M = surface_mass (system, z)
  M = 0;
  for part = system.parts
    M += mass_of_part (part, system.surface, z);
  endfor
endfunction

function M = mass_of_part (part, surface, z)
  b = part.base;
  fields = fields_of_basis (b, z, 0*z, 0*z);
  [of_11, of_12, of_22] = surface.mass (fields, part.rod);
  mixed = sums (b.values{1}, b.values{2}, b.weights.*of_12);
  M = sums (b.values{1}, b.values{1}, b.weights.*of_11) + sums (b.values{2}, b.values{2}, b.weights.*of_22) ...
      + mixed + permute (mixed, [2 1 3]);
  if (part.rod.rhoI > 0)
    [turning{1:4}] = surface.turning (fields);
    functions = [b.values, b.slopes];
    for i = 1:4
      for j = 1:4
        M += sums (functions{[i j]}, part.rod.rhoI*b.weights.*turning{i}.*turning{j});
      endfor
    endfor
  endif
endfunction

## of products of two rows of functions, by densities (a column a page of the result)
function S = sums (rows_1, rows_2, densities)
  [p, n] = size (rows_1);
  products = rows_1.*reshape (rows_2, p, 1, n);
  S = reshape (reshape (products, p, n^2).'*densities, n, n, []);
endfunction

%!test # of a rod that moves along itself as a whole, with what hangs at its end
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, "tip_mass", 5, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1.5), "model", struct ("modes", [3 3]));
%! system = surface_rod (check_surface_scene (scene));
%! M = surface_mass (system, zeros (6, 2));
%! assert (M(1,1,:), reshape ([8 8], 1, 1, 2), 1e-12); assert (M(1,2,2), 5, 1e-12);  # at the end the slope's is 1
%! rotary = surface_rod (check_surface_scene (setfield (scene, "rod", "rhoI", 0.1)));
%! assert (surface_mass (rotary, zeros (6, 1))(5,5) - M(5,5,1), 0.1*2, 1e-12);  # its slope there is 2/l
%!function multiplies_accelerations (system)
%!  [z, e] = deal (0.1*ones (system.n, 1), full (eye (system.n)));
%!  still = 0*z;
%!  M = system.residual (0.5, repmat (z, 1, system.n), 0*e, e) - system.residual (0.5, z, still, still);
%!  assert (surface_mass (system, z), M, 1e-9);
%!endfunction
%!test # it is what multiplies the accelerations: with all that has inertia, and where the chart's lines are aslant
%! multiplies_accelerations (surface_rod (torus_pendulum ()));
%! multiplies_accelerations (surface_rod (check_surface_scene (setfield (saddle (), "model", "modes", [4 4]))));
%!test # and as a hub turns the chart
%! for surface = {struct("name", "plane", "inclination", 0.7), struct("name", "sphere", "radius", 2)}
%!   scene = on_level_plane ("surface", surface{1}, "ends", {{"clamped", "free"}}, "tip_mass", 0.3, ...
%!                           "rotation", @(t) [0.3*t^2 + t, 0.6*t + 1, 0.6]);
%!   scene.rod.rhoI = 0.4;
%!   multiplies_accelerations (surface_rod (check_surface_scene (scene)));
%! endfor
