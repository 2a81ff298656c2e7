## -*- texinfo -*-
## @deftypefn {} {@var{history} =} measure_surface (@var{system}, @var{scene}, @var{times}, @var{states})
## What is observed of a rod on a surface at the @var{times} (1-by-m): t, tip and mid (3-by-m, m, of the tip and of
## mid-span), psi and tip_psi (1-by-m, rad, the tangent's angles at its start and its tip in the tangent plane, from
## the chart's first direction to its second, without jumps of 2 pi), q (N-by-m) with q_names, the units of the
## chart's coordinates (a cellstr), T, U, Z, W, D, balance and energy_floor (J), angular_momentum about the origin
## (3-by-m), reaction (p-by-m, N/m, see @code{normal_reaction}), tip_reaction (N, that to a tip mass; a row, or none),
## support (3-by-m, N, see @code{surface_support}), and the centreline x, y, z (101-by-m, m) with the unit normals n_1,
## n_2, n_3 there.
## @end deftypefn

function history = measure_surface (system, scene, times, states)
  n = system.n;
  z = states(1:n,:);
  z_dot = states(n+1:2*n,:);
  history.t = times;
  history.q = system.place.start + system.place.basis*z;
  history.q_names = coefficient_names (system.numbers);
  history.units = system.surface.units;
  E = system.energies (times, z, z_dot);
  history.T = E(1,:);
  history.U = E(2,:);
  history.Z = E(3,:);
  history.angular_momentum = E(4:6,:);
  history.W = states(2*n+1,:);
  history.D = states(2*n+2,:);
  history.balance = history.T + history.U + history.Z + history.D - history.W;
  history.energy_floor = system.energy_floor;
  history.reaction = normal_reaction (system, times, z, z_dot);
  [history.support, history.torque] = surface_support (system, times, states);
  if (isempty (system.turn (times, z)))
    history.torque = zeros (0, numel (times));  # no hub, no torque
  endif
  history.tip_reaction = reaction_to_tip (system, times, z, z_dot);
  stations = linspace (0, scene.rod.length, 101).';
  fields = system.fields (times, z, z_dot, z_dot, stations);
  [history.x, history.y, history.z] = system.surface.position (fields);
  [history.n_1, history.n_2, history.n_3] = system.surface.normal (fields);
  history.alpha = {fields.alpha1, fields.alpha2};
  place_of = @(k) [history.x(k,:); history.y(k,:); history.z(k,:)];
  history.tip = place_of (101);
  history.mid = place_of (51);
  psi = unwrap (unwrap (system.surface.angle (fields), [], 1), [], 2);
  [history.psi, history.tip_psi] = deal (psi(1,:), psi(end,:));
  history.largest_strain = max (max (abs (system.surface.strains (fields, system.rod))));
endfunction

## along the normal, N, to a tip mass; empty without one
function force = reaction_to_tip (system, t, z, z_dot)
  force = zeros (0, columns (z));
  for part = system.parts(2:end)
    force = system.surface.reaction (fields_of_basis (part.base, z, z_dot, z_dot, system.turn (t, z)), part.rod, ...
                                     system.gravity);
  endfor
endfunction

%!test # at rest on a level plane
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1.5), "model", struct ("modes", [3 3]));
%! scene = check_surface_scene (scene);
%! system = surface_rod (scene);
%! history = measure_surface (system, scene, [0 1], [system.initial_state, system.initial_state]);
%! assert (history.tip, [2 2; 0 0; 0 0], 1e-12);
%! assert (history.reaction, 1.5*9.81*ones (12, 2), 1e-10);
%! assert (history.q_names{4}, "alpha2_0");
%!test # what a force along the level plane does to a stiff rod: its work, and no other energy
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, "force", [3 0 0], ...
%!                 "rod", struct ("length", 2, "EA", 1e5, "EI", 1, "rhoA", 1.5), "model", struct ("modes", [3 3]));
%! run = run_model (surface_kind (), check_surface_scene (scene), surface_rod (check_surface_scene (scene)));
%! history = run.history;
%! assert (history.W(end), 3*3/3/2, 1e-2); assert (history.T(end), 3*3/3/2, 1e-2);  # F s, s = F t^2/(2 rhoA l)
%! assert (history.balance, history.balance(1)*ones (size (history.t)), 1e-6);
%!test # a rod of 2 m and 3 kg that moves across itself at 3 m/s on a slope: its energies, and its angular momentum
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0.3), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1.5), "model", struct ("modes", [3 3]));
%! scene.initial.velocity = @(xi, alpha) [0*xi; 3 + 0*xi];
%! scene.initial.point = [1 2];
%! scene = check_surface_scene (scene);
%! system = surface_rod (scene);
%! state = system.initial_state;
%! state(end-1:end) = [7; 2];
%! history = measure_surface (system, scene, [0 1], [state, state]);
%! assert (history.T, 1.5*2*3^2/2*[1 1], 1e-9); assert (history.U, [0 0], 1e-9); assert (history.W, [7 7]);
%! height = mean (history.z(:,1));
%! assert (history.Z, 3*9.81*height*[1 1], 1e-6); assert (abs (height) > 0.1);
%! assert (history.balance, history.T + history.Z - 5, 1e-9); assert (history.D, [2 2]);
%! assert (norm (history.angular_momentum(:,1)), 3*2*3, 1e-9);
%! assert (history.largest_strain < 1e-9); assert (numel (history.q_names), 6);
%!test # tangent's angles as the start has them, along a rod that winds, and mid-span
%! scene = struct ("surface", struct ("name", "cone", "half_angle", 0.5), "duration", 1, ...
%!                 "rod", struct ("length", 0.2, "EA", 3, "EI", 1, "rhoA", 1), "model", struct ("modes", [9 9]));
%! scene.initial = struct ("point", [1 0], "angle", 3);
%! scene = check_surface_scene (setfield (scene, "solver", "tolerance", 1e-9));
%! system = surface_rod (scene);
%! history = measure_surface (system, scene, [0 1], [system.initial_state, system.initial_state]);
%! assert (history.psi, [3 3], 1e-6);
%! ## a geodesic of the cone is straight on its unrolled plane, whose angle about the tip it changes by
%! [x, y] = deal (1 + 0.2*cos (3), 0.2*sin (3));
%! assert (history.tip_psi, (3 - atan2 (y, x))*[1 1], 1e-6);
%! middle = hypot (1 + 0.1*cos (3), 0.1*sin (3));
%! assert (norm (history.mid(:,1)), middle, 1e-6); assert (history.mid(3,1), middle*cos (0.5), 1e-6);
%! assert (norm (history.tip(:,1)), hypot (x, y), 1e-6);
%!test # a tangent that turns beyond pi goes on
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 1, "EA", 3, "EI", 1, "rhoA", 1), "model", struct ("modes", [12 12]));
%! scene.initial.shape = @(xi) [sin(4*xi); 1 - cos(4*xi)]/4;
%! scene = check_surface_scene (setfield (scene, "solver", "tolerance", 1e-9));
%! system = surface_rod (scene);
%! history = measure_surface (system, scene, 0, system.initial_state);
%! assert ([history.psi, history.tip_psi], [0 4], 1e-6);
