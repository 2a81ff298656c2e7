## -*- texinfo -*-
## @deftypefn {} {[@var{E}, @var{p}] =} rod_energies_of (@var{phi}, @var{phi_dot}, @var{q}, @var{q_dot}, @var{c})
## @var{E} = [T; U; Z] (3-by-m, J) and the angular momentum @var{p} (kg m^2/s) of the rod with the constants @var{c} of
## @code{rod_constants}, by @code{rod_energies}.
## @end deftypefn

function [E, p] = rod_energies_of (phi, phi_dot, q, q_dot, c)
  motion = struct ("phi", phi, "phi_dot", phi_dot, "V", q, "V_dot", q_dot);
  [T, U, Z, p] = rod_energies (motion, c.rod, c.gravity);
  if (! isempty (c.joined))
    U += pull_of_joints (zeros (size (phi)), motion, c.joined).energy;
  endif
  E = [T; U; Z];
endfunction

%!test # a rigid rod of 4.68 kg that turns, upright: J = m (l^2/3 + h^2/3), and its weight half a metre up
%! [scene, model] = sample_rod ([0 0]);
%! c = rod_constants (scene, model);
%! [E, p] = rod_energies_of (pi/2, 2, zeros (0, 1), zeros (0, 1), c);
%! J = 4.68*(1 + 0.015^2)/3;
%! assert (E, [2*J; 0; 4.68*9.81/2], 1e-12); assert (p, 2*J, 1e-12);
%!test # a half wave of 1 mm at rest in the frame: its strain energy, and what it adds to the rotation's; on its way
%! [scene, model] = sample_rod ([0 1], "model.energy", "uniaxial", "model.rotary_inertia", false);
%! c = rod_constants (scene, model);
%! E_modulus = 8.1e10*(3*1.2e11 + 2*8.1e10)/(1.2e11 + 8.1e10);
%! EI = E_modulus*0.02*0.03^3/12;
%! [E, p] = rod_energies_of ([0 0], [2 0], [1e-3 0], [0 3], c);
%! assert (E(2,:), [pi^4/4*EI*1e-6, 0], 1e-9*pi^4/4*EI*1e-6);
%! assert (E(1,:), [2*(4.68/3 + 4.68/2*1e-6), 4.68/4*9], 1e-9);
%! assert (E(3,:), [4.68*9.81*2/pi*1e-3, 0], 1e-12);
%! assert (p, [2*(4.68/3 + 4.68/2*1e-6), 3*4.68/pi], 1e-9);
