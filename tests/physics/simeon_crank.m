## -*- texinfo -*-
## @deftypefn {} {[@var{phi}, @var{x}, @var{q}] =} simeon_crank (@var{block}, @var{tolerance})
## The slider-crank "crank" of the Test Set for IVP Solvers (Mazzia and Magherini; B. Simeon, Math. Modelling of Systems 2,
## 1996), from its quasi-stationary initial values: the rod's angle, the block's place and the amplitudes q1 to q4 at t = 0.1 s.
## Its coefficient matrices are put into the place of ours, the axial mass block times @var{block}: it has 8, 1, 1, 2 there,
## derivation gives 1/15 of that.
##
## Its rod has u = 4 s (1 - s) q3 + s (2 s - 1) q4, w = sin (pi s) q1 + sin (2 pi s) q2, s = x/l: V = (q3, q4, q1, q2).
## @end deftypefn

function [phi, x, q] = simeon_crank (block, tolerance)
  [scene, mechanism] = crank_of_simeon (block);
  system = mechanism_system (scene, mechanism);
  start = assemble_mechanism (scene, mechanism, system);
  rod = index_of (mechanism, 2);
  start.q(rod) = [0.103339863e-4; 0.169327969e-4; 0; 0; 0; 0.15; 0];
  start.v(rod) = [-0.178591076e-5; -0.268938672e-5; 0.444896105; 0.463434311e-2; -74.9957670; 0; 22.5];
  start.v = project_velocities (system, 0, start.q, start.v);
  states = integrate_constrained (system, [0 0.1], start, struct ("name", "radau", "tolerance", tolerance));
  at = marker_motion (mechanism, states.q(:,2), states.v(:,2));
  phi = states.q(rod(5),2);
  x = at.x(mechanism.marker_of(4,1));
  q = states.q(rod([3 4 1 2]),2);
endfunction

function [scene, mechanism] = crank_of_simeon (block)
  scene = check_mechanism (slider_crank ());
  mechanism = build_mechanism (scene, mechanism_rungs (scene, [0 0]));
  PI = 3.1415927;  # as there
  [l, b, rho, E] = deal (0.30, 0.0080^2, 7870, 0.20e12);
  [M, K, B] = deal (zeros (4));
  M([1 2],[1 2]) = rho*b*l*[8 1; 1 2]*block;
  M([3 4],[3 4]) = rho*b*l*eye (2)/2;
  K([1 2],[1 2]) = E*b/l*[16 -8; -8 7]/3;
  K([3 4],[3 4]) = E*b/l*(0.0080/l)^2*PI^4*diag ([1/24 2/3]);
  B(3,1) = -16/PI^3; B(3,2) = 8/PI^3 - 1/PI; B(4,2) = 0.5/PI;
  B -= B.';
  B *= b*l;
  arrays = struct ("mass_matrix", M, "centrifugal_matrix", M, "stiffness_matrix", K, "gyroscopic_matrix", rho*B.', ...
                   "coupling_vector", rho*l*b*l*[0; 0; 1/PI; -0.5/PI], "centrifugal_vector", rho*l*b*l*[1/3; 1/6; 0; 0], ...
                   "first_moment_1", rho*b*l*[2/3; 1/6; 0; 0], "first_moment_2", rho*b*l*[0; 0; 2/PI; 0], ...
                   "shortened_moment_matrix", zeros (4), "moment_of_inertia", 0.0045339259, ...
                   "static_moment", 0.151104*l/2, "mass", 0.151104);
  arrays = with_block (arrays, l, 0.075552);
  rod = mechanism.place(2,1);
  mechanism.groups(rod).model.arrays = mechanism.models{2}.arrays = arrays;
  mechanism.groups(rod).arguments = free_rod_arguments (mechanism.groups(rod).model, 0);
  for k = 1:numel (mechanism.markers)
    if (mechanism.markers(k).group == rod)
      at_tip = mechanism.markers(k).arguments{1} > 0;
      mechanism.markers(k).arguments(2:3) = {[0; at_tip; 0; 0], zeros(4, 1)};
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

%!test # as printed there
%! [phi, x, q] = simeon_crank (1, 1e-8);
%! assert (phi, -0.3311734987910881, 1e-8);
%! assert (x, 0.1697373326718410, 1e-8);
%! assert (q, [1.893192460247178e-4; 2.375751865617931e-5; -5.323907988763734e-6; -8.363283141616840e-6], 1e-8);
