## -*- texinfo -*-
## @deftypefn {} {@var{K} =} geometric_stiffness (@var{mechanism}, @var{q}, @var{F})
## Minus the derivative by q of the generalized forces that constant forces and moments on the markers have, @var{F} =
## struct of x, y (N), angle (N m; markers-by-1), in the one state @var{q} (n-by-1): sparse n-by-n.
## @end deftypefn

function K = geometric_stiffness (mechanism, q, F)
  K = sparse (mechanism.n, mechanism.n);
  for group = mechanism.markers
    index = mechanism.groups(group.group).index(:,group.columns);
    [R, bodies] = size (index);
    i = group.numbers;
    Q = reshape (q(index), R, bodies);
    motion = struct ("phi", Q(end-2,:), "V", Q(1:end-3,:));
    loads = struct ("force_x", F.x(i).', "force_y", F.y(i).', "force_angle", F.angle(i).');
    [phi_phi, phi_V, shortening, slope_1_1, slope_1_2, slope_2_2] = rod_marker_tangent (
      motion, loads, group.marker);
    slope_1 = group.marker.slope_1;
    slope_2 = group.marker.slope_2;
    matrix = group.marker.shortening_matrix;
    cross = slope_1*slope_2.';
    for b = 1:bodies
      V_V = shortening(b)*matrix + slope_1_1(b)*(slope_1*slope_1.') + slope_1_2(b)*(cross + cross.') ...
            + slope_2_2(b)*(slope_2*slope_2.');
      V_and_phi = index(1:end-2,b);
      K(V_and_phi,V_and_phi) -= [V_V, phi_V(:,b); phi_V(:,b).', phi_phi(b)];
    endfor
  endfor
endfunction

%!test # by differences
%! [system, start] = sample_mechanism ([1 2]);
%! rand ("seed", 5);
%! [q, h] = deal (start.q + 0.01*rand (system.n, 1), 1e-6);
%! F = struct ("x", rand (10, 1), "y", rand (10, 1), "angle", rand (10, 1));
%! forces = @(q) forces_of_markers (system.mechanism, marker_motion (system.mechanism, q, 0*q), F);
%! K = geometric_stiffness (system.mechanism, q, F);
%! for k = 1:system.n
%!   step = h*(1:system.n == k).';
%!   assert (K(:,k), (forces (q - step) - forces (q + step))/(2*h), 1e-8);
%! endfor
