## -*- texinfo -*-
## @deftypefn {} {@var{E} =} surface_energies (@var{system}, @var{t}, @var{z}, @var{z_dot})
## Kinetic energy, strain energy, with that of springs, potential energy of gravity (J) and the three components of the
## angular momentum about the origin (kg m^2/s), a row each, of the rod of @code{surface_rod}: 6-by-m at the m times
## @var{t} and states.
## @end deftypefn

function E = surface_energies (system, t, z, z_dot)
  E = zeros (6, columns (z));
  turn = system.turn (t, z);
  E(2,:) += springs_on_surface (system, t, z, z_dot).energy;
  for part = system.parts
    [density{1:6}] = system.surface.energies (fields_of_basis (part.base, z, z_dot, z_dot, turn), part.rod, ...
                                                system.gravity);
    E += cell2mat (cellfun (@(d) part.base.weights.'*d, density.', "uniformoutput", false));
  endfor
endfunction
%!test # a rod that turns about its start on the level plane
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1.5), "model", struct ("modes", [3 3]));
%! scene.initial.velocity = @(xi, alpha) [0*xi; 5*xi];
%! system = surface_rod (check_surface_scene (scene));
%! n = system.n;
%! assert (surface_energies (system, 0, system.initial_state(1:n), system.initial_state(n+1:2*n)), ...
%!         [50; 0; 0; 0; 0; 20], 1e-10);
%! scene.rod.rhoI = 0.1;  # of each section about its own normal
%! system = surface_rod (check_surface_scene (scene));
%! assert (surface_energies (system, 0, system.initial_state(1:n), system.initial_state(n+1:2*n)), ...
%!         [52.5; 0; 0; 0; 0; 21], 1e-10);
