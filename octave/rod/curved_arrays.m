## -*- texinfo -*-
## @deftypefn {} {@var{arrays} =} curved_arrays (@var{base}, @var{axis}, @var{section}, @var{rod})
## The coefficient arrays of a curved hinged rod, as @code{rod_arrays} has them of a straight one, by Gauss quadrature
## of the derived densities; @var{section} comes from @code{rod_section}, and the paper's energy takes the width,
## half_height, lambda, mu of @var{rod} (else []).
## @end deftypefn

function arrays = curved_arrays (base, axis, section, rod)
  f = curved_functions (base, axis, axis.xi);
  n = columns (f.e);
  w = axis.weights(:);
  [c, d, s, r] = curved_rod_modes (in_pairs (f, 1:n, "j"), repeated (axis, n), section);
  [J, S_1, ~, m] = curved_rod_constants (axis, section);
  [k, j] = meshgrid (1:n, 1:n);
  row = in_pairs (f, j, "j");
  column = in_pairs (f, k, "k");
  [M, G] = curved_rod_pairs (row, column, repeated (axis, n*n), section);
  if (isempty (rod))
    K = curved_rod_stiffness_uniaxial (row, column, section);
  else
    K = curved_rod_stiffness_paper (row, column, rod);
  endif
  matrix = @(density) reshape (w.'*density, n, n);
  vector = @(density) (w.'*density).';
  symmetric = @(A) (A + A.')/2;
  M = symmetric (matrix (M));
  G = matrix (G);
  arrays = struct ("mass_matrix", M, "gyroscopic_matrix", (G - G.')/2, "centrifugal_matrix", M, ...
                   "coupling_vector", vector (c), "centrifugal_vector", vector (d), "moment_of_inertia", J*w, ...
                   "stiffness_matrix", symmetric (matrix (K)), "static_moment", S_1*w, ...
                   "first_moment_1", vector (s), "first_moment_2", vector (r), "mass", m*w, ...
                   "shortened_moment_matrix", zeros (n));
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

%!test # without curvature they are the straight rod's closed forms
%! section = struct ("rhoA", 3, "rhoI", 0.01, "EA", 5, "EI", 7, "GI", 0);
%! base = base_functions (1:2, 1:3, 1.5);
%! expected = rod_arrays (base, section, 0);
%! axis = rod_axis (struct ("length", 1.5, "curvature", 0, "curvature_breaks", []), 8);
%! found = curved_arrays (base, axis, section, []);
%! for [value, name] = expected
%!   assert (found.(name), value, 1e-10*max (1, norm (value)));
%! endfor
