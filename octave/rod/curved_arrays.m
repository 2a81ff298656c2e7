## -*- texinfo -*-
## @deftypefn {} {@var{arrays} =} curved_arrays (@var{base}, @var{axis}, @var{section}, @var{rod}, @var{tip_mass})
## The coefficient arrays of a curved hinged rod, as @code{rod_arrays} has them of a straight one, by Gauss quadrature
## of the derived densities; @var{section} comes from @code{rod_section}, and the paper's energy takes the width,
## half_height, lambda, mu of @var{rod} (else []).  A @var{tip_mass} (kg) is a thin section of that mass per length, one
## unit long.
## @end deftypefn

function arrays = curved_arrays (base, axis, section, rod, tip_mass = 0)
  [arrays, row, column] = inertia (base, axis, axis, section);
  if (tip_mass > 0)
    tip = struct ("xi", base.length, "kappa", 0, "weights", 1);
    [tip.x, tip.y, tip.theta] = undeformed_places (struct ("axis", axis), base.length);
    for [value, name] = inertia (base, axis, tip, struct ("rhoA", tip_mass, "rhoI", 0))
      arrays.(name) += value;
    endfor
  endif
  arrays.centrifugal_matrix = arrays.mass_matrix;
  if (isempty (rod))
    K = curved_rod_stiffness_uniaxial (row, column, section);
  else
    K = curved_rod_stiffness_paper (row, column, rod);
  endif
  n = rows (arrays.mass_matrix);
  arrays.stiffness_matrix = symmetric (reshape (axis.weights*K, n, n));
  arrays.shortened_moment_matrix = zeros (n);
endfunction

## of what lies at those points, where row and column are all base functions with all
function [arrays, row, column] = inertia (base, axis, points, section)
  f = curved_functions (base, axis, points.xi);
  n = columns (f.e);
  [k, j] = meshgrid (1:n, 1:n);
  row = in_pairs (f, j, "j");
  column = in_pairs (f, k, "k");
  w = points.weights(:);
  vector = @(density) (w.'*density).';
  [c, d, s, r] = curved_rod_modes (in_pairs (f, 1:n, "j"), repeated (points, n), section);
  [J, S_1, ~, m] = curved_rod_constants (points, section);
  [M, G] = curved_rod_pairs (row, column, repeated (points, n*n), section);
  G = reshape (w.'*G, n, n);
  arrays = struct ("mass_matrix", symmetric (reshape (w.'*M, n, n)), "gyroscopic_matrix", (G - G.')/2, ...
                   "coupling_vector", vector (c), "centrifugal_vector", vector (d), "moment_of_inertia", J*w, ...
                   "static_moment", S_1*w, "first_moment_1", vector (s), "first_moment_2", vector (r), "mass", m*w);
endfunction

function A = symmetric (A)
  A = (A + A.')/2;
endfunction

## the base functions in this order (columns), u_1 as u_1_j for one
function part = in_pairs (f, order, name)
  for [value, key] = f
    part.([key "_" name]) = value(:,order(:));
  endfor
endfunction

## the axis at its points, a column for each of n columns of base functions
function points = repeated (axis, n)
  for name = {"x", "y", "theta", "kappa"}
    points.(name{1}) = axis.(name{1})(:)*ones (1, n);
  endfor
endfunction

%!test # without curvature they are the straight rod's closed forms, and with a tip mass its
%! section = struct ("rhoA", 3, "rhoI", 0.01, "EA", 5, "EI", 7, "GI", 0);
%! base = base_functions (1:2, 1:3, 1.5);
%! expected = add_point_mass (rod_arrays (base, section, 0), base, 1.5, 0.7, 0);
%! axis = rod_axis (struct ("length", 1.5, "curvature", 0, "curvature_breaks", []), 8);
%! found = curved_arrays (base, axis, section, [], 0.7);
%! for [value, name] = expected
%!   assert (found.(name), value, 1e-10*max (1, norm (value)));
%! endfor
