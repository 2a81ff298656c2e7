## -*- texinfo -*-
## @deftypefn {} {[@var{springs}, @var{distance}] =} springs_on_surface (@var{system}, @var{t}, @var{z}, @var{z_dot})
## The springs and dampers from places in space to a rod on a surface (see @code{surface_rod}) at the m times @var{t}
## and states: a struct of their generalized forces (n-by-m), torque about the chart's origin (1-by-m, N m; of a rod in
## a hub), energy (J), what they dissipate (dissipated, W; 1-by-m both) and the sum of their forces on the rod (force,
## 3-by-m, N); and the @var{distance} of their ends (m, a row a spring).
## @end deftypefn

function [springs, distance] = springs_on_surface (system, t, z, z_dot)
  s = system.springs;
  springs = struct ("forces", 0*z, "torque", 0, "energy", 0, "dissipated", 0, "force", 0);
  distance = [];
  if (isempty (s.stiffness))
    return;
  endif
  every = ones (1, columns (z));
  turn = system.turn (t, z);
  fields = fields_of_basis (s.base, z, z_dot, z_dot, turn);
  point = struct ("point_1", s.point(:,1)*every, "point_2", s.point(:,2)*every, "point_3", s.point(:,3)*every);
  [distance, distance_dot, by_1, by_2] = system.surface.spring (fields, point);
  [energy, dissipated, tension] = spring_law (distance - s.rest, distance_dot, s.stiffness*every, s.damping*every);
  [springs.forces, springs.torque] = work_on_base (s.base, {-tension.*by_1, -tension.*by_2}, fields, turn);
  springs.energy = sum (energy, 1);
  springs.dissipated = sum (dissipated, 1);
  [x, y, up] = system.surface.position (fields);
  pull = tension./distance;
  springs.force = [sum(pull.*(point.point_1 - x), 1); sum(pull.*(point.point_2 - y), 1); ...
                   sum(pull.*(point.point_3 - up), 1)];
endfunction

%!test # by Pythagoras: 3 and 4 to the side and above
%! spring = struct ("kind", "spring", "stations", 2, "point", [2 3 4], "stiffness", 7, "damping", 0.5, "rest", 3);
%! system = surface_rod (check_surface_scene (on_level_plane ("joints", {{spring}})));
%! spin = system.place.basis.'*[0 0 0 1 1 0].';
%! [springs, distance] = springs_on_surface (system, 0, zeros (system.n, 1), spin);
%! assert (distance, 5, 1e-12); assert (springs.energy, 7*2^2/2, 1e-12);
%! rate = -2*3/5;  # as the tip goes 2 m/s towards it
%! pull = 7*2 + 0.5*rate;
%! assert (springs.dissipated, 0.5*rate^2, 1e-12); assert (springs.force, pull*[0; 3; 4]/5, 1e-12);
%! assert (spin.'*springs.forces, -pull*rate, 1e-12);
%!error <joint 1: its point is on the rod at the start>
%! spring = struct ("kind", "spring", "stations", 1, "point", [1 0 0], "stiffness", 1);
%! surface_rod (check_surface_scene (on_level_plane ("joints", {{spring}})));
