## -*- texinfo -*-
## @deftypefn {} {[@var{K}, @var{D}] =} tangent_of_joints (@var{t}, @var{V}, @var{phi}, @var{joined})
## Stiffness and damping matrix, (n+1)-by-(n+1) in (V, phi), of the springs, dampers and loads of a @code{joined_rod}
## at the time @var{t} in the place @var{V} (n-by-1), @var{phi}: minus the derivatives of their forces, by central
## differences of a millionth of the rod's length.
## @end deftypefn

function [K, D] = tangent_of_joints (t, V, phi, joined)
  n = rows (V);
  h = 1e-6*[joined.length*ones(n, 1); 1];
  none = zeros (n + 1);
  steps = diag (h);
  q = [V; phi] + [steps, -steps, none, none];
  v = [none, none, steps, -steps];
  motion = struct ("V", q(1:n,:), "phi", q(n+1,:), "V_dot", v(1:n,:), "phi_dot", v(n+1,:));
  pull = pull_of_joints (t(ones (1, columns (q))), motion, joined);
  forces = reshape ([pull.V; pull.phi], n + 1, n + 1, 4);
  K = (forces(:,:,2) - forces(:,:,1))./(2*h.');
  D = (forces(:,:,4) - forces(:,:,3))./(2*h.');
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
