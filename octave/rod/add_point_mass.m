## -*- texinfo -*-
## @deftypefn {} {@var{arrays} =} add_point_mass (@var{arrays}, @var{base}, @var{station}, @var{mass}, @
##   @var{shortening})
## The @var{arrays} of @code{rod_arrays} with a point @var{mass} (kg) at the @var{station} (m) of the centreline.
## @end deftypefn

function arrays = add_point_mass (arrays, base, station, mass, shortening)
  [along, across] = functions_at (base, station);
  [along_k, along_j] = meshgrid (along, along);
  [across_k, across_j] = meshgrid (across, across);
  Q = shortening*shortening_at (base, station);
  [M, G, N, Y] = point_mass_pairs (along_j, across_j, along_k, across_k, Q, station, mass);
  [c, d, s, r] = point_mass_modes (along.', across.', station, mass);
  [J, S, m] = point_mass_constants (station, mass);
  added = struct ("mass_matrix", M, "gyroscopic_matrix", G, "centrifugal_matrix", N, "shortened_moment_matrix", Y, ...
                  "coupling_vector", c, "centrifugal_vector", d, "first_moment_1", s, "first_moment_2", r, ...
                  "moment_of_inertia", J, "static_moment", S, "mass", m);
  for [value, name] = added
    arrays.(name) += value;
  endfor
endfunction

%!test # many equal point masses along it are a rod of that mass
%! base = base_functions ([1 2 -1 -0.4], [1 2 -1], 1.5);
%! section = struct ("rhoA", 3, "rhoI", 0, "EA", 5, "EI", 7, "GI", 0);
%! nothing = setfield (section, "rhoA", 0);
%! expected = rod_arrays (base, section, 1);
%! arrays = rod_arrays (base, nothing, 1);
%! for k = 1:400
%!   arrays = add_point_mass (arrays, base, 1.5*(k - 0.5)/400, 3*1.5/400, 1);
%! endfor
%! for [value, name] = expected
%!   assert (arrays.(name), value, 1e-4);
%! endfor
