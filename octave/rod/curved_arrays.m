## -*- texinfo -*-
## @deftypefn {} {@var{arrays} =} curved_arrays (@var{base}, @var{axis}, @var{section}, @var{rod})
## The coefficient arrays of a curved hinged rod, as @code{rod_arrays} has them of a straight one, by Gauss quadrature
## of the derived densities; @var{section} comes from @code{rod_section}, and the paper's energy takes the width,
## half_height, lambda, mu of @var{rod} (else []).
## @end deftypefn

function arrays = curved_arrays (base, axis, section, rod)
  f = curved_functions (base, axis, axis.xi);
  n = columns (f.e);
  p = numel (axis.xi);
  w = axis.weights(:);
  column = @(row) row(:)*ones (1, n);
  theta = column (axis.theta);
  kappa = column (axis.kappa);
  x = column (axis.x);
  y = column (axis.y);
  [c, d, s, r] = curved_rod_modes (f.u_1, f.u_2, f.e, f.chi, x, y, theta, kappa, section.rhoA, section.rhoI);
  [J, S_1, S_2] = curved_rod_constants (axis.x, axis.y, axis.theta, axis.kappa, section.rhoA, section.rhoI);
  of = @(g, order) reshape (g(:,order), p, []);
  [k, j] = meshgrid (1:n, 1:n);
  at = @(g) {of(g, j), of(g, k)};
  pair = cellfun (at, {f.u_1, f.u_2, f.e, f.chi}, "uniformoutput", false);
  pair = vertcat (pair{:});
  every = ones (1, n*n);
  [M, G] = curved_rod_pairs (pair{:,1}, pair{:,2}, axis.theta(:)*every, axis.kappa(:)*every, ...
                             section.rhoA, section.rhoI);
  strain = cellfun (at, {f.e, f.e_slope, f.bend}, "uniformoutput", false);
  strain = vertcat (strain{:});
  if (isempty (rod))
    K = curved_rod_stiffness_uniaxial (strain{:,1}, strain{:,2}, section.EA, section.EI);
  else
    K = curved_rod_stiffness_paper (strain{:,1}, strain{:,2}, rod.width, rod.half_height, rod.lambda, rod.mu);
  endif
  matrix = @(density) reshape (w.'*density, n, n);
  vector = @(density) (w.'*density).';
  symmetric = @(A) (A + A.')/2;
  M = symmetric (matrix (M));
  G = matrix (G);
  arrays = struct ("mass_matrix", M, "gyroscopic_matrix", (G - G.')/2, "centrifugal_matrix", M, ...
                   "coupling_vector", vector (c), "centrifugal_vector", vector (d), "moment_of_inertia", J*w, ...
                   "stiffness_matrix", symmetric (matrix (K)), "static_moment", S_1*w, ...
                   "first_moment_1", vector (s), "first_moment_2", vector (r), "shortened_moment_matrix", zeros (n));
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
