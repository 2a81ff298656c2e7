## -*- texinfo -*-
## @deftypefn {} {[@var{V_ddot}, @var{phi_ddot}, @var{torque}] =} hub_accelerations (@var{inverse_mass}, @
##   @var{m}, @var{mm}, @var{g}, @var{force_V}, @var{force_phi}, @var{r})
## Accelerations (n-by-k and 1-by-k) of a rod in a hub at k times, and the hub's torque (1-by-k, N m): the multiplier
## of the constraint @var{g}.' V_ddot + phi_ddot = @var{r} (see @code{rod_in_hub}).  Its mass matrix is
## [mass, @var{m}; @var{m}.', @var{mm}] (see @code{rod_forces}).
##
## With phi_ddot and the torque put in, the mass matrix of V is that of the modes, whose inverse is constant, and
## [m g]*[0 -1; -1 mm]*[m g].': Woodbury's formula inverts it.
## @end deftypefn

function [V_ddot, phi_ddot, torque] = hub_accelerations (inverse_mass, m, mm, g, force_V, force_phi, r)
  product = @(a, b) sum (a.*b, 1);
  V_ddot = inverse_mass*(force_V - m.*r + g.*(mm.*r - force_phi));
  solved_m = inverse_mass*m;
  solved_g = inverse_mass*g;
  ## the inverse of [0 -1; -1 mm] is [-mm -1; -1 0]
  a = product (m, solved_m) - mm;
  b = product (m, solved_g) - 1;
  d = product (g, solved_g);
  of_m = product (m, V_ddot);
  of_g = product (g, V_ddot);
  determinant = a.*d - b.^2;
  V_ddot -= solved_m.*((d.*of_m - b.*of_g)./determinant) + solved_g.*((a.*of_g - b.*of_m)./determinant);
  phi_ddot = r - product (g, V_ddot);
  torque = product (m, V_ddot) + mm.*phi_ddot - force_phi;
endfunction

%!test # the saddle-point system that it solves
%! mass = [3 1; 1 2]; m = [0.4 0.1; -0.3 0.7]; mm = [5 6]; g = [2 0; 1 3]; force_V = [1 2; 3 4]; force_phi = [5 6];
%! [V_ddot, phi_ddot, torque] = hub_accelerations (inv (mass), m, mm, g, force_V, force_phi, [7 8]);
%! for k = 1:2
%!   expected = [mass, m(:,k), -g(:,k); m(:,k).', mm(k), -1; g(:,k).', 1, 0] \ [force_V(:,k); force_phi(k); 6 + k];
%!   assert ([V_ddot(:,k); phi_ddot(k); torque(k)], expected, 1e-12);
%! endfor
%!test # a rigid rod
%! [V_ddot, phi_ddot, torque] = hub_accelerations (zeros (0, 0), zeros (0, 1), 3, zeros (0, 1), zeros (0, 1), 7, 2);
%! assert (torque, 3*2 - 7);
