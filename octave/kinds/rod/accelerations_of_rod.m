## -*- texinfo -*-
## @deftypefn {} {@var{accelerations} =} accelerations_of_rod (@var{n}, @var{c})
## The hinged rod of @var{n} coordinates in coordinates and their rates, z = (q; phi; q_dot; phi_dot; W; D), for
## methods of structural dynamics: a struct of rate (t, z), state (z) = y of @code{hinged_rod} and
## form (y) = z.  @var{c} comes from @code{rod_constants}.
## @end deftypefn

function accelerations = accelerations_of_rod (n, c)
  accelerations.rate = @(t, z) rate (t, z, n, c);
  accelerations.state = @(z) state (z, n, c);
  accelerations.form = @(y) form (y, n, c);
endfunction

function z_dot = rate (t, z, n, c)
  [m, mm, force_V, force_phi, power, dissipated] = rod_forces (
    t, z(n+1,:), z(2*n+2,:), z(1:n,:), z(n+2:2*n+1,:), c);
  [V_ddot, phi_ddot] = rod_accelerations (c.rod, m, mm, force_V, force_phi);
  z_dot = [z(n+2:2*n+2,:); V_ddot; phi_ddot; power; dissipated];
endfunction

function y = state (z, n, c)
  y = z;
  [~, y(2*n+2,:)] = rod_energies_of (z(n+1,:), z(2*n+2,:), z(1:n,:), z(n+2:2*n+1,:), c);
endfunction

function z = form (y, n, c)
  z = y;
  motion = struct ("V", y(1:n,:), "phi", y(n+1,:), "V_dot", y(n+2:2*n+1,:), "angular_momentum", y(2*n+2,:));
  [~, z(2*n+2,:)] = rod_momenta (motion, c.rod, c.gravity);
endfunction

%!test # there and back, and the same motion as the rates of the state
%! [scene, model] = sample_rod ([2 3], "rod.damping", 1e-4, "rod.half_height", 0.1, "rod.lambda", 1e8, "rod.mu", 1e8);
%! system = hinged_rod (scene, model);
%! y = [0.01*[1 -2 3 4 -5].'; 0.4; [1 2 -3 -4 5].'/10; 30; 0; 0];
%! z = system.accelerations.form (y);
%! assert (system.accelerations.state (z), y, 1e-12);
%! h = 1e-6;
%! z_dot = system.accelerations.rate (0.1, z);
%! moved = (system.accelerations.state (z + h*z_dot) - system.accelerations.state (z - h*z_dot))/(2*h);
%! y_dot = system.rate (0.1, y);
%! assert (moved, y_dot, 1e-7*norm (y_dot));
%! both = system.accelerations.rate ([0.1 0.2], [z -z]);
%! assert (both(:,1), z_dot, 1e-12*norm (z_dot));
