## -*- texinfo -*-
## @deftypefn {} {[@var{mechanism}, @var{along}] =} simeon_arrays (@var{mechanism}, @var{has})
## The slider-crank's @var{mechanism} with the connecting rod's arrays as the Test Set for IVP Solvers has
## them, changed where @var{has} (name) says (see @code{simeon_crank}); @var{along} (2-by-4): u (l/2) and
## u (l) by the amplitudes.
##
## Its rod has u = 4 s (1 - s) q3 + s (2 s - 1) q4, w = sin (pi s) q1 + sin (2 pi s) q2, s = x/l: V = (q3, q4, q1, q2).
## @end deftypefn

function [mechanism, along] = simeon_arrays (mechanism, has)
  along = [1 0 0 0; 0 1 0 0];
  PI = [3.1415927, pi](1 + has ("pi"));
  [l, b, rho, E] = deal (0.30, 0.0080^2, 7870, 0.20e12);
  [M, K, B] = deal (zeros (4));
  M([1 2],[1 2]) = rho*b*l*[8 1; 1 2]/[1, 15](1 + has ("axial mass"));
  M([3 4],[3 4]) = rho*b*l*eye (2)/2;
  K([1 2],[1 2]) = E*b/l*[16 -8; -8 7]/3;
  K([3 4],[3 4]) = E*b/l*(0.0080/l)^2*PI^4*diag ([1/24 2/3]);
  B(3,1) = -16/PI^3; B(3,2) = 8/PI^3 - 1/PI; B(4,2) = 0.5/PI;
  B -= B.';
  B *= b*l;
  J_2 = [0.0045339259, 0.151104*l^2/3](1 + has ("J2"));
  arrays = struct ("mass_matrix", M, "centrifugal_matrix", M, "stiffness_matrix", K, "gyroscopic_matrix", rho*B.', ...
                   "coupling_vector", rho*l*b*l*[0; 0; 1/PI; -0.5/PI], ...
                   "centrifugal_vector", rho*l*b*l*[1/3; 1/6; 0; 0], ...
                   "first_moment_1", rho*b*l*[2/3; 1/6; 0; 0], "first_moment_2", rho*b*l*[0; 0; 2/PI; 0], ...
                   "shortened_moment_matrix", zeros (4), "moment_of_inertia", J_2, ...
                   "static_moment", 0.151104*l/2, "mass", 0.151104, "damping", 0);
  arrays = with_block (arrays, l, 0.075552);
  rod = mechanism.place(2,1);
  mechanism.groups(rod).model.arrays = mechanism.models{2}.arrays = arrays;
  for k = 1:numel (mechanism.markers)
    if (mechanism.markers(k).group == rod)
      at_tip = mechanism.markers(k).marker.place_1 > 0;
      mechanism.markers(k).marker.shape_1 = [0; at_tip; 0; 0];  # base functions there
      mechanism.markers(k).marker.shape_2 = zeros (4, 1);
    endif
  endfor
endfunction

## the block slides with the rod's tip
function arrays = with_block (arrays, l, mass)
  [along, across] = deal ([0 1 0 0], [0 0 0 0]);
  [along_k, along_j] = meshgrid (along, along);
  [across_k, across_j] = meshgrid (across, across);
  [M, G, N] = point_mass_pairs (along_j, across_j, along_k, across_k, zeros (4), l, mass);
  [c, d, s, r] = point_mass_modes (along.', across.', l, mass);
  [J, S] = point_mass_constants (l, mass);
  added = struct ("mass_matrix", M, "gyroscopic_matrix", G, "centrifugal_matrix", N, "coupling_vector", c, ...
                  "centrifugal_vector", d, "first_moment_1", s, "first_moment_2", r, "moment_of_inertia", J, ...
                  "static_moment", S, "mass", mass);
  for [value, name] = added
    arrays.(name) += value;
  endfor
endfunction

%!test # pi of more digits and a derived mass block change what they say
%! scene = check_mechanism (slider_crank ());
%! mechanism = build_mechanism (scene, mechanism_rungs (scene, [0 0]));
%! ours = mechanism.models{2}.arrays;
%! theirs = simeon_arrays (mechanism, @(name) false).models{2}.arrays;
%! changed = simeon_arrays (mechanism, @(name) true).models{2}.arrays;
%! assert (norm (changed.mass_matrix(3:4,3:4) - ours.mass_matrix(3:4,3:4)) < 1e-12);
%! assert (changed.moment_of_inertia, ours.moment_of_inertia, 1e-12);
%! assert ((changed.mass_matrix - theirs.mass_matrix)(1,1), -0.151104*8*14/15, 1e-6);
%! assert (changed.coupling_vector(3:4), ours.coupling_vector(3:4), 1e-6);
