## -*- texinfo -*-
## @deftypefn {} {[@var{E}, @var{p}] =} rod_energies_of (@var{phi}, @var{phi_dot}, @var{q}, @var{q_dot}, @var{c})
## @var{E} = [T; U; Z] (3-by-m, J) and the angular momentum @var{p} (kg m^2/s) of the rod with the constants @var{c} of
## @code{rod_constants}, by @code{rod_energies}.
## @end deftypefn

function [E, p] = rod_energies_of (phi, phi_dot, q, q_dot, c)
  [T, U, Z, p] = rod_energies (phi, phi_dot, q, q_dot, c.energy_arguments{:});
  E = [T; U; Z];
endfunction

%!test # a rigid rod that turns and stands upright
%! scene = check_scene (setfield (paper (), "model", "modes", [0 0]));
%! c = rod_constants (scene, build_model (scene, rung_of_scene (scene)));
%! [E, p] = rod_energies_of (pi/2, 2, zeros (0, 1), zeros (0, 1), c);
%! assert (E, [2*c.energy_arguments{6}; 0; 9.81*c.energy_arguments{9}], 1e-12);
%! assert (p, 2*c.energy_arguments{6}, 1e-12);
