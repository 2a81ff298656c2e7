## -*- texinfo -*-
## @deftypefn {} {@var{system} =} surface_rod (@var{scene})
## The rod of a checked scene (see @code{check_surface_scene}) on its surface as a system y_dot = rate (t, y, interval)
## with the state y = (z; z_dot; W): coordinates in what the ends leave free, q = start + basis*z, their rates, work of
## the loads.
##
## Fields: n coordinates, numbers (of polynomials, modes, and sines), initial_state, place (see @code{place_rod}),
## residual (t, z, z_dot, z_ddot) = mass times acceleration less forces (n-by-m, at m times), power (t, z, z_dot) of
## the loads, mass_matrix (z) and tangent_stiffness (t, z, z_dot, z_ddot; n-by-n-by-m both), rate, energies (z, z_dot;
## see @code{surface_energies}), refuse_singular (z, when), size (z), the largest displacement (m) that goes with a
## small change of z, fields (z, z_dot, z_ddot, stations) = place, as the surface's functions take it, at stations of
## the rod, surface, rod and gravity (likewise), points and weights (p-by-1, m, of the quadrature), breaks,
## state_scale, mass, stiffness (linear about the start), energy_floor (J), forms, auto, duration.
## @end deftypefn

function system = surface_rod (scene)
  surface = surface_functions (scene.surface);
  for name = {"moment", "tip_moment", "force"}
    scene.(name{1}) = watched_load (name{1}, scene.(name{1}));
  endfor
  loads = {scene.moment, scene.tip_moment, scene.force};
  system.loaded = any (cellfun (@(load) ! isnumeric (load) || any (load), loads));
  system.place = place_rod (scene, surface);
  system.surface = surface;
  system.numbers = struct ("modes", scene.model.modes, "sines", scene.model.sines);
  system.n = columns (system.place.basis);
  [x, weights] = gauss_rule (quadrature_points (scene.model));
  system.points = scene.rod.length*x.';
  system.weights = scene.rod.length*weights.';
  r = scene.rod;
  system.rod = r;
  system.gravity = scene.gravity;
  system.duration = scene.duration;
  inside = surface_basis (scene, system.place, system.points);
  ends = surface_basis (scene, system.place, [0; r.length]);
  system.fields = @(z, z_dot, z_ddot, stations) fields_of_basis (surface_basis (scene, system.place, stations), z, ...
                                                                 z_dot, z_ddot);
  system.residual = @(t, z, z_dot, z_ddot) residual (t, z, z_dot, z_ddot, inside, ends, system, scene);
  system.power = @(t, z, z_dot) sum (z_dot.*load_of (t, z, ends, system, scene), 1);
  system.mass_matrix = @(z) mass_matrix (z, inside, system, r);
  system.rate = @(t, y, interval) rate (t, y, interval, system);
  system.energies = @(z, z_dot) surface_energies (system, z, z_dot);
  system.energy_floor = energy_floor (rod_moment_of_inertia (r.length, r.rhoA, 0), scene.duration);
  system.tangent_stiffness = @(varargin) tangent_stiffness (system, varargin{:});
  everywhere = linspace (0, r.length, 501).';
  system.refuse_singular = @(z, when) refuse_singular (surface, system.fields (z, z, z, everywhere), when);
  start = zeros (system.n, 1);
  velocity = system.place.basis.'*system.place.velocity;
  system.refuse_singular (start, "at the start");
  scale = lengths_per_coordinate (surface, fields_of_basis (inside, start, velocity, start));
  system.size = @(z) max (max (abs (inside.values{1}*z)*scale(1), abs (inside.values{2}*z)*scale(2))(:));
  if (strcmp (scene.initial.from, "equilibrium"))
    start = equilibrium (surface_at_rest (scene, system), 0);
    velocity = 0*start;
  else
    start = quasi_stationary (system, start, velocity, scene.solver.tolerance/20);
  endif
  system.mass = system.mass_matrix (start);
  system.stiffness = system.tangent_stiffness (0, start, velocity, start);
  per_coordinate = 1./max (max (abs (inside.values{1}))*scale(1), max (abs (inside.values{2}))*scale(2)).';
  system.initial_state = [start; velocity; 0];
  system.state_scale = [per_coordinate; per_coordinate/scene.duration; ...
                        rod_mass(r.length, r.rhoA)*abs(scene.gravity) + r.EI/r.length^2];
  system.breaks = scene.moment_breaks;
  system.forms = {"rate", "residual"};
  system.auto = "radau";
  system.warnings = {};
  system.energy_rows = numel (system.initial_state);
endfunction

function R = residual (t, z, z_dot, z_ddot, b, ends, system, scene)
  fields = fields_of_basis (b, z, z_dot, z_ddot);
  [d{1:6}] = system.surface.balance (fields, system.rod, system.gravity);
  if (scene.rod.rhoI > 0)
    [rotary{1:4}] = system.surface.rotary_balance (fields, system.rod);
    d(1:4) = cellfun (@plus, d(1:4), rotary, "uniformoutput", false);
  endif
  w = system.weights;
  R = b.values{1}.'*(w.*d{1}) + b.values{2}.'*(w.*d{2}) + b.slopes{1}.'*(w.*d{3}) + b.slopes{2}.'*(w.*d{4}) ...
      + b.seconds{1}.'*(w.*d{5}) + b.seconds{2}.'*(w.*d{6}) - load_of (t, z, ends, system, scene);
endfunction

## generalized forces of the loads at both ends
function Q = load_of (t, z, ends, system, scene)
  if (! system.loaded)
    Q = 0*z;
    return;
  endif
  loads = [at_times(scene.moment, t); at_times(scene.tip_moment, t); at_times(scene.force, t)];
  loads = repmat (loads, 1, columns (z)/numel (t));
  none = 0*loads(1,:);
  f = fields_of_basis (ends, z, z, z);
  [d{1:4}] = system.surface.point_loads (f, struct ("force_1", [none; loads(3,:)], "force_2", [none; loads(4,:)], ...
                                             "force_3", [none; loads(5,:)], "moment", loads(1:2,:)));
  Q = ends.values{1}.'*d{1} + ends.values{2}.'*d{2} + ends.slopes{1}.'*d{3} + ends.slopes{2}.'*d{4};
endfunction

## a page a state
function M = mass_matrix (z, b, system, rod)
  fields = fields_of_basis (b, z, 0*z, 0*z);
  densities = cell (1, 3);
  [densities{:}] = system.surface.mass (fields, rod);
  turning = cell (1, 4);
  if (rod.rhoI > 0)
    [turning{:}] = system.surface.turning (fields);
  endif
  M = zeros (rows (z), rows (z), columns (z));
  for k = 1:columns (z)
    of_state = @(density) system.weights.*density(:,k);
    mixed = b.values{1}.'*(of_state (densities{2}).*b.values{2});
    own = b.values{1}.'*(of_state (densities{1}).*b.values{1}) + b.values{2}.'*(of_state (densities{3}).*b.values{2}) ...
          + mixed + mixed.';
    if (rod.rhoI > 0)
      rate = turning{1}(:,k).*b.values{1} + turning{2}(:,k).*b.values{2} ...
             + turning{3}(:,k).*b.slopes{1} + turning{4}(:,k).*b.slopes{2};
      own += rate.'*(rod.rhoI*system.weights.*rate);
    endif
    M(:,:,k) = own;
  endfor
endfunction

function y_dot = rate (t, y, interval, system)
  n = system.n;
  t = min (max (t, interval(1)), interval(2));
  z = y(1:n,:);
  z_dot = y(n+1:2*n,:);
  R = system.residual (t, z, z_dot, zeros (size (z)));
  M = system.mass_matrix (z);
  for k = 1:columns (y)
    z_ddot(:,k) = -(M(:,:,k) \ R(:,k));
  endfor
  y_dot = [z_dot; z_ddot; system.power(t, z, z_dot)];
endfunction

function scale = lengths_per_coordinate (surface, fields)
  [a_11, ~, a_22] = surface.mass (fields, struct ("rhoA", 1));
  scale = sqrt ([max(a_11(:)), max(a_22(:))]);
endfunction

%!function scene = pendulum ()
%!  scene = struct ("surface", struct ("name", "torus", "core_radius", 1, "tube_radius", 0.4), "duration", 1, ...
%!                  "rod", struct ("length", 1, "EA", 100, "EI", 0.1, "EI_normal", 0.2, "GJ", 0.3, "rhoA", 2, ...
%!                                 "rhoI", 0.4), ...
%!                  "ends", {{"hinge", "free"}}, "model", struct ("modes", [4 5]), ...
%!                  "tip_moment", 0.3, "force", [1 2 3]);
%!  scene.initial = struct ("angle", 1);
%!  scene = check_surface_scene (scene);
%!endfunction

%!test # power of all forces is the rate of the energies, at a random state
%! rand ("seed", 1);
%! system = surface_rod (pendulum ());
%! [z, z_dot, z_ddot] = deal (0.1*rand (system.n, 1), rand (system.n, 1), rand (system.n, 1));
%! h = 1e-5;
%! E = @(s) sum (surface_energies (system, z + s*z_dot + s^2/2*z_ddot, z_dot + s*z_ddot)(1:3,:), 1);
%! rate = (8*(E (h) - E (-h)) - (E (2*h) - E (-2*h)))/(12*h);
%! power = z_dot.'*system.residual (0, z, z_dot, z_ddot) + system.power (0, z, z_dot);
%! assert (power, rate, 1e-7*abs (rate));
%!test # the work may be off by what weight and bending do over so many metres
%! system = surface_rod (pendulum ());
%! assert (system.state_scale(end), 2*1*9.81 + 0.1/1^2, 1e-12);
%! long = surface_rod (setfield (pendulum (), "rod", "length", 0.5));
%! assert (long.state_scale(end), 2*0.5*9.81 + 0.1/0.5^2, 1e-12);
%!test # where the chart's lines are not at right angles, too
%! scene = setfield (saddle (), "model", "modes", [4 4]);
%! system = surface_rod (check_surface_scene (scene));
%! [z, e] = deal (0.1*ones (system.n, 1), full (eye (system.n)));
%! M = system.residual (0, repmat (z, 1, system.n), 0*e, e) - system.residual (0, z, 0*z, 0*z);
%! assert (system.mass_matrix (z), M, 1e-9);
%!test # the mass matrix is what multiplies the accelerations
%! system = surface_rod (pendulum ());
%! [z, e] = deal (0.1*ones (system.n, 1), full (eye (system.n)));
%! M = system.residual (0, repmat (z, 1, system.n), 0*e, e) - system.residual (0, z, 0*z, 0*z);
%! assert (system.mass_matrix (z), M, 1e-9);
%!error <the rod meets a point at the start where the surface's chart is singular, near alpha = \(0.001, 0\)>
%! scene = struct ("surface", struct ("name", "cone", "half_angle", 1), "duration", 1, ...
%!                 "rod", struct ("length", 1, "EA", 100, "EI", 0.1, "rhoA", 2), "model", struct ("modes", [4 4]));
%! scene.initial.point = [1e-3 0];
%! surface_rod (check_surface_scene (scene));
%!test # its rates are those that leave no residual, times beyond an interval are those of its ends, and what it tells
%! system = surface_rod (pendulum ());
%! y = [0.05*ones(system.n, 1); 0.3*ones(system.n, 1); 0];
%! [z, z_dot] = deal (y(1:system.n), y(system.n+1:end-1));
%! y_dot = system.rate (0.1, y, [0 1]);
%! assert (system.residual (0.1, z, z_dot, y_dot(system.n+1:end-1)), zeros (system.n, 1), 1e-9);
%! assert (y_dot(1:system.n), z_dot); assert (y_dot(end), system.power (0.1, z, z_dot), 1e-12);
%! scene = pendulum ();
%! scene.force = @(t) [t 0 0];
%! system = surface_rod (scene);
%! for times = {-1, 0.2; 5, 0.7; 0.4, 0.4}.'
%!   assert (system.rate (times{1}, y, [0.2 0.7]), system.rate (times{2}, y, [0 1]), 1e-12);
%! endfor
%! assert (norm (system.rate (0.2, y, [0 1]) - system.rate (0.7, y, [0 1])) > 1e-3);
%! two = system.residual ([0.2 0.7], [z, z], [z_dot, z_dot], 0*[z, z]);
%! assert (two, [system.residual(0.2, z, z_dot, 0*z), system.residual(0.7, z, z_dot, 0*z)], 1e-12);
%! assert (system.initial_state(end), 0); assert (system.energy_rows, 2*system.n + 1);
%! assert ({system.forms, system.auto, system.warnings, system.duration}, {{"rate", "residual"}, "radau", {}, 1});
