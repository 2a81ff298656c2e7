## -*- texinfo -*-
## @deftypefn {} {@var{system} =} surface_rod (@var{scene})
## The rod of a checked scene (see @code{check_surface_scene}) on its surface as a system y_dot = rate (t, y)
## with the state y = (z; z_dot; W; D): coordinates in what the ends leave free, q = start + basis*z, their rates, work
## of the loads, what is dissipated.
##
## Fields: n coordinates, numbers (of polynomials, modes, and sines), initial_state, place (see @code{place_rod}),
## residual (t, z, z_dot, z_ddot; see @code{surface_residual}), power (t, z, z_dot, z_ddot; see @code{surface_power}),
## mass_matrix (z), tangent_stiffness and tangent_damping (t, z, z_dot, z_ddot; n-by-n-by-m), damped, rate, energies (t,
## z, z_dot; see @code{surface_energies}), refuse_singular (z, when), size (z), the largest displacement (m) that goes
## with a small change of z, turn (t, z) of what moves the chart (see @code{turned_fields}), stopped () = the system in
## which that stands still where it is at the time, fields (t, z, z_dot, z_ddot, stations) = place, as the surface's
## functions take it, at stations of the rod, surface, rod and gravity (likewise), points and weights (p-by-1, m, of the
## quadrature), parts (what has mass: base, with its weights, and rod, of the rod and of a tip mass, a rod at one place
## without stiffness), loads and springs (see @code{held_on_surface}), breaks, state_scale, mass, stiffness (linear
## about the start), energy_floor (J), energy_rows (of W and D in y), forms, auto, warnings, duration.
## @end deftypefn

function system = surface_rod (scene)
  surface = surface_functions (scene.surface);
  r = scene.rod;
  system.place = place_rod (scene, surface);
  system.surface = surface;
  system.numbers = struct ("modes", scene.model.modes, "sines", scene.model.sines);
  system.n = columns (system.place.basis);
  [x, weights] = gauss_rule (quadrature_points (scene.model));
  system.points = r.length*x.';
  system.weights = r.length*weights.';
  system.rod = r;
  system.gravity = scene.gravity;
  system.duration = scene.duration;
  base_at = @(stations, weights) surface_basis (scene, system.place, stations, weights);
  inside = base_at (system.points, system.weights);
  system.parts = struct ("base", inside, "rod", r);
  if (scene.tip_mass > 0)
    point = struct ("rhoA", scene.tip_mass, "rhoI", 0, "EA", 0, "EI", 0, "EI_normal", 0, "GJ", 0, "damping", 0, ...
                    "engineering", 0);
    system.parts(2) = struct ("base", base_at (r.length, 1), "rod", point);
  endif
  [system.loads, system.springs] = held_on_surface (scene, base_at);
  system.damped = any ([r.damping; system.springs.damping] > 0);
  system = turned_by (system, base_at, turning_of (scene));
  system.energy_floor = energy_floor (rod_moment_of_inertia (r.length, r.rhoA, 0), scene.duration);
  everywhere = base_at (linspace (0, r.length, 501).', []);
  fields = @(z) fields_of_basis (everywhere, z, z, z, system.turn (0, z));
  system.refuse_singular = @(z, when) refuse_singular (surface, fields (z), when);
  system.refuse_singular (zeros (system.n, 1), "at the start");
  refuse_no_direction (system, zeros (system.n, 1));
  system = started_on_surface (system, scene);
  system.breaks = scene.breaks;
  system.forms = {"rate", "residual"};
  system.auto = "radau";
  system.warnings = {};
  system.energy_rows = 2*system.n + [1 2];
endfunction

## its functions of time and state, as a hub turns the chart
function system = turned_by (system, base_at, turn)
  system.turn = turn;
  system.fields = @(t, z, z_dot, z_ddot, stations) fields_of_basis (base_at (stations, []), z, z_dot, ...
                                                                    z_ddot, turn (t, z));
  system.residual = @(t, z, z_dot, z_ddot) surface_residual (system, t, z, z_dot, z_ddot);
  system.power = @(t, z, z_dot, z_ddot) surface_power (system, t, z, z_dot, z_ddot);
  system.mass_matrix = @(z) surface_mass (system, z);
  system.rate = @(t, y) rate (t, y, system);
  system.energies = @(t, z, z_dot) surface_energies (system, t, z, z_dot);
  system.tangent_stiffness = @(varargin) tangent_stiffness (system, varargin{:});
  system.tangent_damping = @(varargin) tangent_damping (system, varargin{:});
  system.stopped = @() turned_by (system, base_at, @(t, z) without_rates (turn (t, z)));
endfunction

function turn = without_rates (turn)
  turn(mod (1:rows (turn), 3) != 1,:) = 0;
endfunction

function y_dot = rate (t, y, system)
  n = system.n;
  z = y(1:n,:);
  z_dot = y(n+1:2*n,:);
  R = system.residual (t, z, z_dot, zeros (size (z)));
  M = system.mass_matrix (z);
  for k = 1:columns (y)
    z_ddot(:,k) = -(M(:,:,k) \ R(:,k));
  endfor
  y_dot = [z_dot; z_ddot; system.power(t, z, z_dot, z_ddot)];
endfunction

## what moves the chart, and its rates, 3-by-m where it only turns, or 9-by-m; empty where nothing does
function turn = turning_of (scene)
  turn = @(t, z) [];
  rotation = watched_columns ("rotation", scene.rotation);
  place = watched_columns ("place", scene.place);
  if (! isempty (place))
    if (isempty (rotation))
      rotation = @(t) zeros (3, numel (t));
    endif
    turn = @(t, z) repmat ([rotation(t); place(t)], 1, columns (z)/numel (t));
  elseif (! isempty (rotation))
    turn = @(t, z) repmat (rotation (t), 1, columns (z)/numel (t));
  endif
endfunction

function refuse_no_direction (system, z)
  [~, apart] = springs_on_surface (system, 0, z, z);
  k = find (apart <= 1e-9*system.rod.length, 1);
  if (! isempty (k))
    scene_error ("%s: its point is on the rod at the start, so that its force has no direction: take another place", ...
                 system.springs.names{k});
  endif
endfunction

%!error <the rod meets a point at the start where the surface's chart is singular, near alpha = \(0.001, 0\)>
%! scene = struct ("surface", struct ("name", "cone", "half_angle", 1), "duration", 1, ...
%!                 "rod", struct ("length", 1, "EA", 100, "EI", 0.1, "rhoA", 2), "model", struct ("modes", [4 4]));
%! scene.initial.point = [1e-3 0];
%! surface_rod (check_surface_scene (scene));
%!test # its rates are those that leave no residual, and what it tells
%! system = surface_rod (torus_pendulum ());
%! y = [0.05*ones(system.n, 1); 0.3*ones(system.n, 1); 0; 0];
%! [z, z_dot] = deal (y(1:system.n), y(system.n+1:end-2));
%! y_dot = system.rate (0.1, y);
%! assert (system.residual (0.1, z, z_dot, y_dot(system.n+1:end-2)), zeros (system.n, 1), 1e-9);
%! assert (y_dot(1:system.n), z_dot); assert (y_dot(end-1:end), system.power (0.1, z, z_dot, z_dot), 1e-12);
%! scene = torus_pendulum ();
%! scene.force = @(t) [t 0 0];
%! system = surface_rod (scene);
%! assert (norm (system.rate (0.2, y) - system.rate (0.7, y)) > 1e-3);
%! two = system.residual ([0.2 0.7], [z, z], [z_dot, z_dot], 0*[z, z]);
%! assert (two, [system.residual(0.2, z, z_dot, 0*z), system.residual(0.7, z, z_dot, 0*z)], 1e-12);
%! assert (system.initial_state(end-1:end), [0; 0]); assert (system.energy_rows, 2*system.n + [1 2]);
%! assert ({system.forms, system.auto, system.warnings, system.duration}, {{"rate", "residual"}, "radau", {}, 1});
