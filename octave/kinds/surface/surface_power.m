## -*- texinfo -*-
## @deftypefn {} {@var{power} =} surface_power (@var{system}, @var{t}, @var{z}, @var{z_dot}, @var{z_ddot})
## What the loads on a rod on a surface (see @code{surface_rod}), and what turns or moves its chart, do, and what
## dampers and the material dissipate, at the m times @var{t} and states: 2-by-m, W.
## @end deftypefn

function power = surface_power (system, t, z, z_dot, z_ddot)
  turn = system.turn (t, z);
  dissipated = springs_on_surface (system, t, z, z_dot).dissipated + zeros (1, columns (z));
  rod = system.parts(1);
  if (rod.rod.damping > 0)
    fields = fields_of_basis (rod.base, z, z_dot, z_dot, turn);
    [~, ~, ~, ~, ~, ~, density] = system.surface.damping (fields, rod.rod);
    dissipated += rod.base.weights.'*density;
  endif
  [loads, torque] = loads_on_surface (system, t, z);
  power = [sum(z_dot.*loads, 1); dissipated];
  if (! isempty (turn))
    [~, of_hub] = surface_residual (system, t, z, z_dot, z_ddot);
    power(1,:) += sum (turn(2:3:end,:).*(torque + of_hub), 1);
  endif
endfunction

%!test # what loads do where they are, and what the material and a damper take
%! damper = struct ("kind", "spring", "stations", 1, "point", [1 4 0], "damping", 0.5);
%! scene = on_level_plane ("force", [0 3 0], "force_station", 0.5, "joints", {{damper}});
%! system = surface_rod (check_surface_scene (setfield (scene, "rod", "damping", 0.1)));
%! spin = system.place.basis.'*[0 0 0 1 1 0].';  # at 1 rad/s
%! still = zeros (system.n, 1);
%! assert (surface_power (system, [0 1], [still still], [spin 2*spin], [still still]), [1.5 3; 0.5 2], 1e-12);
%! stretch = system.place.basis.'*[1 1 0 0 0 0].';  # by 1/s
%! assert (surface_power (system, 0, still, stretch, still), [0; 0.1*30*2], 1e-12);
