## -*- texinfo -*-
## @deftypefn {} {[@var{K}, @var{D}] =} tangent_of_joints (@var{t}, @var{V}, @var{phi}, @var{joined})
## Stiffness and damping matrix, (n+1)-by-(n+1) in (V, phi), of the springs, dampers and loads of a @code{joined_rod}
## at the time @var{t} in the place @var{V} (n-by-1), @var{phi}, at rest: minus the derivatives of their forces.
##
## With the elongations' derivatives e_q they are K = e_q' k e_q, D = e_q' d e_q, and K has what the tensions and loads
## do as they turn: a quadratic form, which the accelerations without those of the coordinates give in any direction.
## @end deftypefn

function [K, D] = tangent_of_joints (t, V, phi, joined)
  n = rows (V) + 1;
  one = eye (n);
  [i, j] = find (triu (ones (n), 1));
  [springs, turning] = towards ([one, one(:,i) + one(:,j)], t, V, phi, joined);
  mixed = zeros (n);
  mixed(sub2ind ([n n], i, j)) = (turning(n+1:end) - turning(i) - turning(j))/2;
  by_elongations = springs.velocity(:,1:n);
  K = by_elongations.'*(springs.stiffness(:,1).*by_elongations) + diag (turning(1:n)) + mixed + mixed.';
  D = by_elongations.'*(springs.damping(:,1).*by_elongations);
endfunction

## the springs, and what their tensions and the loads do along each of the directions, columns (V_dot; phi_dot)
function [springs, turning] = towards (directions, t, V, phi, joined)
  none = zeros (2, columns (directions));
  every = ones (1, columns (directions));
  q = [[V; phi]*every; none];
  v = [directions; none];
  at = marker_motion (joined, columns (v), @(group) motion_of_rods (q, v));
  convection = marker_convection (joined, q, v);
  springs = spring_forces (joined, at);
  tension = springs.tension - springs.damping.*springs.velocity;  # at rest
  bent = constraint_convection (joined.springs, prescribed_values (joined.springs, t*every), at, springs, convection);
  turning = sum (tension.*bent, 1);
  if (! isempty (joined.loads))
    F = applied_forces (joined, applied_values (joined.loads, t*every), at);
    turning -= sum (F.x.*convection.x + F.y.*convection.y + F.angle.*convection.angle, 1);
  endif
endfunction

%!test # a torsion spring and damper at O, of the tangent's angle; and a spring across the middle
%! torsion = struct ("kind", "torsion_spring", "stations", 0, "stiffness", 5, "damping", 2);
%! spring = struct ("kind", "spring", "stations", 0.5, "point", [0.5 1], "rest", 1, "stiffness", 7, "damping", 3);
%! [scene, model] = sample_rod ([0 2], "joints", {torsion});
%! [K, D] = tangent_of_joints (0, [0; 0], 0, joined_rod (model, scene.joints));
%! g = [model.arrays.slope_2; 1];
%! assert (K, 5*g*g.', 1e-6); assert (D, 2*g*g.', 1e-6);
%! [scene, model] = sample_rod ([0 2], "joints", {spring});
%! [K, D] = tangent_of_joints (0, [0; 0], 0, joined_rod (model, scene.joints));
%! g = [1; 0; 0.5];
%! assert (K, 7*g*g.', 1e-6); assert (D, 3*g*g.', 1e-6);
%!test # all of them in a bent place, with loads: by differences of their forces
%! joint = @(kind, station, varargin) struct ("kind", kind, "stations", station, varargin{:});
%! joints = {joint("spring", 0.5, "point", [0.5 1], "rest", 0.7, "stiffness", 7, "damping", 3), ...
%!           joint("bushing", 1, "point", [0.8 0.3], "stiffness", 4, "damping", 2), ...
%!           joint("torsion_spring", 0, "stiffness", 5, "damping", 1), joint("force", 0.7, "value", [3 -4]), ...
%!           joint("moment", 1, "value", 2)};
%! [scene, model] = sample_rod ([1 2], "joints", joints, "model.stiffening", "foreshortening");
%! joined = joined_rod (model, scene.joints);
%! q = [0.01; 0.03; -0.02; 0.4];
%! pulls = @(q, v) pull_of_joints (0, struct ("V", q(1:3), "phi", q(4), "V_dot", v(1:3), "phi_dot", v(4)), joined);
%! force = @(q, v) [pulls(q, v).V; pulls(q, v).phi];
%! [K, D] = tangent_of_joints (0, q(1:3), q(4), joined);
%! h = 1e-5;
%! for k = 1:4
%!   e = h*((1:4).' == k);
%!   assert (K(:,k), (force (q - e, 0*e) - force (q + e, 0*e))/(2*h), 1e-6);
%!   assert (D(:,k), (force (q, -e) - force (q, e))/(2*h), 1e-6);
%! endfor
