## -*- texinfo -*-
## @deftypefn {} {[@var{R}, @var{torque}] =} surface_residual (@var{system}, @var{t}, @var{z}, @var{z_dot}, @var{z_ddot})
## Mass times acceleration less all forces on a rod on a surface (see @code{surface_rod}), in its coordinates:
## n-by-m, at the m times @var{t} and states; of a rod in a hub also the @var{torque} (1-by-m, N m) that turns it.
## @end deftypefn

function [R, torque] = surface_residual (system, t, z, z_dot, z_ddot)
  turn = system.turn (t, z);
  R = torque = 0;
  if (! isempty (system.loads.values))
    [Q, about] = loads_on_surface (system, t, z);
    R = -Q;
    torque = -about;
  endif
  if (! isempty (system.springs.stiffness))
    springs = springs_on_surface (system, t, z, z_dot);
    R -= springs.forces;
    torque -= springs.torque;
  endif
  for part = system.parts
    fields = fields_of_basis (part.base, z, z_dot, z_ddot, turn);
    d = densities_of (system.surface, fields, part.rod, system.gravity);
    [Q, about] = work_on_base (part.base, d, fields, turn);
    R += Q;
    torque += about;
  endfor
endfunction

function d = densities_of (surface, fields, rod, gravity)
  [d{1:6}] = surface.balance (fields, rod, gravity);
  if (rod.rhoI > 0)
    [rotary{1:4}] = surface.rotary_balance (fields, rod);
    d(1:4) = cellfun (@plus, d(1:4), rotary, "uniformoutput", false);
  endif
  if (rod.damping > 0)
    [damping{1:6}] = surface.damping (fields, rod);
    d = cellfun (@plus, d, damping, "uniformoutput", false);
  endif
endfunction

%!test # a rod that stretches under a force on the way: EA times the strain holds it up to there
%! scene = on_level_plane ("force", [6 0 0], "force_station", 0.5);
%! system = surface_rod (check_surface_scene (scene));
%! still = zeros (system.n, 1);
%! stretch = system.place.basis.'*[1 1 0 0 0 0].';
%! assert (stretch.'*surface_residual (system, 0, still, still, still), -6*0.5, 1e-12);
%! assert (stretch.'*surface_residual (system, 0, still, still, stretch), 1.5*2^3/3 - 6*0.5, 1e-12);
%!test # damping stresses it like a strain of so many seconds times its rate
%! system = surface_rod (check_surface_scene (setfield (on_level_plane (), "rod", "damping", 0.1)));
%! still = zeros (system.n, 1);
%! bending = system.place.basis.'*[0 0 0 0.1 0.2 0.3].';
%! assert (surface_residual (system, 0, still, bending, still), ...
%!         0.1*system.tangent_stiffness (0, still, still, still)*bending, 1e-12);
%!test # an arc that is as it was made has no force, and a straight rod that is laid like it has
%! scene = setfield (on_level_plane ("gravity", 0), "rod", "curvature", 0.4);
%! scene.model.modes = [12 12];
%! system = surface_rod (check_surface_scene (setfield (scene, "solver", "tolerance", 1e-12)));
%! still = zeros (system.n, 1);
%! assert (surface_residual (system, 0, still, still, still), still, 1e-7);
%! assert (system.energies (0, still, still)(2), 0, 1e-9);
%! scene.rod.curvature = 0;
%! scene.initial.shape = @(xi) [sin(0.4*xi); 1 - cos(0.4*xi)]/0.4;
%! system = surface_rod (check_surface_scene (setfield (scene, "solver", "tolerance", 1e-12)));
%! assert (system.energies (0, still, still)(2), 1*0.4^2/2*2, 1e-6);
