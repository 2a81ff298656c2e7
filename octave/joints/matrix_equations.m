## -*- texinfo -*-
## @deftypefn {} {@var{equations} =} matrix_equations ()
## What a mechanism asks of bodies whose places are of second order in their amplitudes at most: the rods of the paper,
## with and without foreshortening, in the matrix form of their equations.
##
## A struct of functions of k motions (see @code{motion_of_rods}) of a body's model (see @code{free_rod_model}); R
## coordinates are (V; phi; x; y):
##
## @table @code
## @item dynamics (model, motion, gravity)
## [force, dissipated, d]: generalized forces of weight, stiffness, damping and motion (R-by-k), what dampers take
## (1-by-k, W), and what the next two need
## @item inertia (model, d, a), mass (model, d)
## the mass matrices times a (R-by-k), and themselves (R-by-R-by-k)
## @item energies (model, motion, gravity)
## [T, U, Z] (1-by-k, J)
## @item convection (model, motion)
## what of the momenta's rates comes without accelerations (R-by-k)
## @item marker (model, station)
## what the next four take as marker: a point of the centreline and the tangent there
## @item point (motion, marker)
## [x, y, x_dot, y_dot] and the derivatives [x_phi, y_phi, x_V, y_V] (1-by-k, (R-3)-by-k)
## @item tangent (motion, marker)
## [angle, angle_dot, angle_V], likewise
## @item marker_convection (motion, marker)
## second rates [x, y, angle] without accelerations (1-by-k)
## @item marker_stiffness (motion, loads, marker)
## second derivatives of the work of loads (force_x, force_y, force_angle; 1-by-k) on the marker: [phi_phi, phi_V, V_V]
## (1-by-k, (R-3)-by-k, (R-3)^2-by-k)
## @item centreline (model, stations, motion, zoom)
## [x, y] of the p stations in the frame that is only turned (p-by-k, m), with the deformation times zoom
## @item angle (model, station, phi, V)
## of the tangent at one station (1-by-k, rad)
## @end table
## @end deftypefn

function equations = matrix_equations ()
  equations.dynamics = @dynamics;
  equations.inertia = @inertia;
  equations.mass = @mass;
  equations.energies = @(model, motion, gravity) free_rod_energies (motion, model.arrays, gravity);
  equations.convection = @convection;
  equations.marker = @marker;
  equations.point = @rod_marker;
  equations.tangent = @rod_marker_angle;
  equations.marker_convection = @rod_marker_convection;
  equations.marker_stiffness = @marker_stiffness;
  equations.centreline = @centreline;
  equations.angle = @tangent_at;
endfunction

function [force, dissipated, b] = dynamics (model, motion, gravity)
  [b.V_phi, b.V_x, b.V_y, b.phi_phi, b.phi_x, b.phi_y, V, phi, x, y, dissipated] = ...
    free_rod_equations (motion, model.arrays, gravity);
  force = [V; phi; x; y];
endfunction

function product = inertia (model, b, a)
  n = rows (a) - 3;
  V = a(1:n,:);
  phi = a(n+1,:);
  x = a(n+2,:);
  y = a(n+3,:);
  m = model.arrays.mass;
  product = [model.arrays.mass_matrix*V + b.V_phi.*phi + b.V_x.*x + b.V_y.*y
             sum(b.V_phi.*V, 1) + b.phi_phi.*phi + b.phi_x.*x + b.phi_y.*y
             sum(b.V_x.*V, 1) + b.phi_x.*phi + m*x
             sum(b.V_y.*V, 1) + b.phi_y.*phi + m*y];
endfunction

function M = mass (model, b)
  [n, count] = size (b.V_phi);
  R = n + 3;
  M = zeros (R, R, count);
  M(1:n,1:n,:) = model.arrays.mass_matrix(:,:,ones (1, count));
  last = [b.V_phi; b.phi_phi; b.phi_x; b.phi_y];
  M(:,n+1,:) = M(n+1,:,:) = reshape (last, R, 1, count);
  M(1:n,n+2,:) = M(n+2,1:n,:) = reshape (b.V_x, n, 1, count);
  M(1:n,n+3,:) = M(n+3,1:n,:) = reshape (b.V_y, n, 1, count);
  M(n+2,n+2,:) = M(n+3,n+3,:) = model.arrays.mass;
  M(n+1,n+2,:) = M(n+2,n+1,:) = reshape (b.phi_x, 1, 1, count);
  M(n+1,n+3,:) = M(n+3,n+1,:) = reshape (b.phi_y, 1, 1, count);
endfunction

function f = convection (model, motion)
  [V, phi, x, y] = free_rod_convection (motion, model.arrays);
  f = [V; phi; x; y];
endfunction

function marker = marker (model, station)
  [along, across] = functions_at (model.base, station);
  [slope_1, slope_2] = slopes_at (model.base, station, model.shortening);
  marker = struct ("shape_1", along.', "shape_2", across.', "slope_1", slope_1, "slope_2", slope_2, ...
                   "shortening_matrix", model.shortening*shortening_at (model.base, station));
  marker = project_arrays (marker, model.basis);
  [marker.place_1, marker.place_2, marker.direction] = undeformed_places (model.base, station);
endfunction

function [phi_phi, phi_V, V_V] = marker_stiffness (motion, loads, marker)
  [phi_phi, phi_V, shortening, slope_1_1, slope_1_2, slope_2_2] = rod_marker_tangent (motion, loads, marker);
  slope_1 = marker.slope_1;
  slope_2 = marker.slope_2;
  cross = slope_1*slope_2.';
  V_V = marker.shortening_matrix(:)*shortening + (slope_1*slope_1.')(:)*slope_1_1 ...
        + (cross + cross.')(:)*slope_1_2 + (slope_2*slope_2.')(:)*slope_2_2;
endfunction

%!test # a bent rod in two states: T is v.M.v/2, and a marker is a point of the centreline with the tangent there
%! [system, ~, scene] = sample_mechanism ([1 2]);
%! model = system.mechanism.models{1};
%! of = model.equations;
%! at = @(s) 0.1*sin ((1:rows (model.arrays.mass_matrix) + 3).'*[1 2] + s);
%! [q, v] = deal (at (0), at (1));
%! motion = motion_of_rods (q, v);
%! [~, ~, d] = of.dynamics (model, motion, 9.81);
%! product = of.inertia (model, d, v);
%! M = of.mass (model, d);
%! assert ([M(:,:,1)*v(:,1), M(:,:,2)*v(:,2)], product, 1e-12);
%! assert (of.energies (model, motion, 9.81), sum (v.*product, 1)/2, 1e-12);
%! marker = of.marker (model, model.length/3);
%! [x, y] = of.point (motion, marker);
%! [from_O, above_O] = of.centreline (model, model.length/3, motion, 1);
%! assert ([x; y], [from_O + motion.x; above_O + motion.y], 1e-12);
%! assert (of.tangent (motion, marker), of.angle (model, model.length/3, motion.phi, motion.V), 1e-12);
