## -*- texinfo -*-
## @deftypefn {} {@var{K} =} turning_stiffness (@var{t}, @var{V}, @var{phi}, @var{phi_dot}, @var{c})
## The stiffness matrix, (n+1)-by-(n+1) in (V, phi), of the rod as it turns, by @code{rod_tangent_stiffness}, with that
## of its joints in the place @var{V} (n-by-1) at the time @var{t}, by @code{tangent_of_joints}; @var{c} comes from
## @code{rod_constants}.
## @end deftypefn

function K = turning_stiffness (t, V, phi, phi_dot, c)
  [VV, V_phi, phi_phi] = rod_tangent_stiffness (struct ("phi", phi, "phi_dot", phi_dot), c.rod, c.gravity);
  K = [VV, V_phi; V_phi.', phi_phi];
  if (! isempty (c.joined))
    K += tangent_of_joints (t, V, phi, c.joined);
  endif
endfunction

%!test # minus the derivatives of the forces at V = 0
%! [scene, model] = sample_rod ([1 2], "model.stiffening", "foreshortening", "rod.half_height", 0.1, "moment", 0);
%! c = rod_constants (scene, model);
%! force = @(x) nthargout (3:4, @rod_forces, 0, x(4), 5, x(1:3), zeros (3, 1), c);
%! K = turning_stiffness (0, zeros (3, 1), 0.3, 5, c);
%! for k = 1:4
%!   e = 1e-5*((1:4).' == k);
%!   [above, below] = deal (force ([0; 0; 0; 0.3] + e), force ([0; 0; 0; 0.3] - e));
%!   column = ([below{1}; below{2}] - [above{1}; above{2}])/2e-5;
%!   assert (column, K(:,k), 1e-8*norm (K(:,k)) + 1e-5);
%! endfor
