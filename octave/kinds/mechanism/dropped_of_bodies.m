## -*- texinfo -*-
## @deftypefn {} {@var{dropped} =} dropped_of_bodies (@var{scene}, @var{mechanism}, @var{history})
## How far what the rods' models drop may move a mechanism's points, a struct as from @code{dropped_error} of which only
## the bound is known.  Of straight rods, beyond foreshortening, it is where the forces of what is dropped (see
## @code{dropped_forces}; with weight and rotation, without accelerations) and what the tangents at its joints are
## turned further (see @code{rod_dropped_angle}) hold the mechanism by its joints, springs and stiffness; how much
## nearer points come to the O of their rod; and a quarter of all that for each radian of the phase of what bends,
## which runs ahead by it.  What moves freely resists by its inertia: as far as it comes in half of the duration, or
## within a period of the rods' rotation.  For curved ones see @code{bound_of_curved};
## geometrically exact ones drop nothing.
## @end deftypefn

function dropped = dropped_of_bodies (scene, mechanism, history)
  metres = 0;
  force = q = zeros (mechanism.n, numel (history.t));
  for k = 1:numel (history.bodies)
    model = mechanism.models{k};
    body = history.bodies(k);
    index = index_of (mechanism, k);
    q(index,:) = [body.V; body.phi; body.x; body.y];
    if (! isempty (scene.bodies(k).rod.curvature) && isempty (model.line))
      metres += bound_of_curved (model, body.V, scene.duration);
    elseif (model.rung.bending > 0 && isempty (model.line))
      [force(index(1:end-2),:), nearer] = of_body (model, body, scene.bodies(k).tip_mass, scene.gravity);
      metres += nearer;
    endif
  endfor
  if (any (force(:)))
    rates = vertcat (history.bodies.phi_dot);
    held = held_by_joints (mechanism_system (scene, mechanism), history, q, force, mean (rates(:).^2));
    metres += held*(1 + phase_of (vertcat (history.bodies.V))/4);
  endif
  dropped = struct ("metres", metres, "x", 0, "y", 0, "bound", metres);
endfunction

function [force, nearer] = of_body (model, body, tip_mass, gravity)
  none = 0*body.phi;
  points = dropped_points (model, struct ("tip_mass", tip_mass, "force_station", 0));
  motion = struct ("q", body.V, "q_dot", 0*body.V, "q_ddot", 0*body.V, "phi", body.phi, "phi_dot", body.phi_dot, ...
                   "phi_ddot", none, "x_ddot", none, "y_ddot", none, "followers", []);
  loads = struct ("gravity", gravity, "moment", none, "force_x", none, "force_y", none);
  [force_V, force_phi] = dropped_forces (points, motion, loads);
  force = [force_V; force_phi];
  nearer = max (abs (dropped_shortening (model, linspace (0, model.length, 21), body.V))(:));
endfunction

## metres, at all times at once: K x + Phi_q' lambda = force, Phi_q x + Phi_angle angle = 0
function metres = held_by_joints (system, history, q, force, rate_2)
  mechanism = system.mechanism;
  at = system.at (history.t, q, 0*q);
  [mass, jacobian, spring_jacobian] = system.matrices (at);
  [angle, by_torque] = angles_at_markers (mechanism, q, system.on_markers (at, history.lambda).angle);
  force += by_torque;
  springs = spdiags (at.springs.stiffness(:), 0, rows (spring_jacobian), rows (spring_jacobian));
  K = kron (speye (columns (q)), system.stiffness) + mass*(2/system.duration^2 + rate_2) ...
      + spring_jacobian.'*springs*spring_jacobian;
  pull = spring_jacobian.'*(springs*by_angles (mechanism.springs, at.springs, angle)(:));
  off = by_angles (mechanism.constraints, at.constraints, angle);
  unit = full (mean (abs (diag (mass))));
  none = sparse (rows (jacobian), rows (jacobian));
  for id = {"Octave:singular-matrix", "Octave:nearly-singular-matrix"}  # where a mechanism is in line
    warning ("off", id{1}, "local");
  endfor
  moved = [K, unit*jacobian.'; unit*jacobian, none] \ [force(:) - pull; -unit*off(:)];
  metres = abs (system.q_points*reshape (moved(1:numel (q)), size (q)));
  metres = max ([0; metres(isfinite (metres))]);
endfunction

## by which their tangents turn more than the models have it, and the forces of the torques that work on that
function [angle, force] = angles_at_markers (mechanism, q, torque)
  angle = zeros (mechanism.marker_count, columns (q));
  force = zeros (size (q));
  for group = mechanism.markers
    if (! isempty (mechanism.groups(group.group).model.line))
      continue;
    endif
    slope = group.marker.slope_2.'*motion_of_group (group, q, 0*q).V;
    [turned, ~, by_slope] = rod_dropped_angle (slope, 0*slope, 0*slope, 0*slope);
    angle(group.numbers,:) = reshape (turned, numel (group.numbers), []);
    works = group.marker.slope_2*(reshape (torque(group.numbers,:), 1, []).*by_slope);
    force(group.index(1:end-3,:),:) += reshape (works, [], columns (q));
  endfor
endfunction

function off = by_angles (constraints, c, angle)
  off = zeros (size (c.residual));
  for i = 1:numel (c.gradients)
    kind = constraints.kinds(i);
    off(kind.rows,:) += along_markers (0, kind, c.gradients{i}, {0*angle, 0*angle, angle});
  endfor
endfunction

## rad, of the amplitudes that are not small: a way of twice the largest is half a period
function phase = phase_of (V)
  largest = max (abs (V), [], 2);
  way = sum (abs (diff (V, 1, 2)), 2);
  seen = largest >= 0.3*max (largest);
  phase = pi/2*max ([0; way(seen)./largest(seen)]);
endfunction

%!function metres = of_half_wave (amplitudes)   # a sin (pi xi/l) between supports
%!  at = @(kind, station) struct ("kind", kind, "bodies", 1, "stations", station);
%!  scene.joints = {at("revolute", 0), setfield(at ("slider", 2), "direction", 0)};
%!  scene.bodies = {struct("rod", struct ("length", 2, "EA", 1e9, "EI", 20, "rhoA", 1), ...
%!                         "model", struct ("modes", [0 1], "stiffening", "foreshortening"))};
%!  [scene.duration, scene.gravity] = deal (1, 0);
%!  scene = check_mechanism (scene);
%!  mechanism = build_mechanism (scene, mechanism_rungs (scene, 0));
%!  none = 0*amplitudes;
%!  history = struct ("t", linspace (0, 1, numel (amplitudes)), "lambda", repmat (none, 3, 1), ...
%!                    "bodies", struct ("V", amplitudes, "phi", none, "phi_dot", none, "x", none, "y", none));
%!  metres = dropped_of_bodies (scene, mechanism, history).bound;
%!endfunction
%!test # its stiffness grows by s^2/2 of itself, s = a pi/l, which takes its share of the phase
%! s = 0.02*pi/2;
%! assert (of_half_wave ([0.02 0.02]), 0.02*s^2/2, 0.02*0.02*s^2);
%! assert (of_half_wave (0.02*cos (linspace (0, 2*pi, 101))), 0.02*s^2/2*(1 + 2*pi/4), 0.03*0.02*s^2);

%!function tip = elastica (P)   # of a cantilever of unit length and stiffness under a dead force across it
%!  rates = @(s, y) [y(2); -P*cos(y(1)); cos(y(1)); sin(y(1))];
%!  ends = @(bend) nthargout (2, @ode45, rates, [0 1], [0; bend; 0; 0], odeset ("RelTol", 1e-9, "AbsTol", 1e-11))(end,:);
%!  tip = ends (fzero (@(bend) ends (bend)(2), [0.2 1.5]*P))(3:4);
%!endfunction
%!test # a cantilever at rest: by how much its model is off the elastica
%! at = @(kind, station) struct ("kind", kind, "bodies", 1, "stations", station);
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e8, "EI", 1, "rhoA", 1), ...
%!                        "model", struct ("stiffening", "foreshortening"))};
%! scene.joints = {at("weld", 0), setfield(at ("force", 1), "value", [0 0.3])};
%! [scene.gravity, scene.duration] = deal (0, 1);
%! scene = check_mechanism (scene);
%! mechanism = mechanism_kind ().sized (scene, 12);
%! balance = mechanism_at_rest (scene, mechanism);
%! [q, lambda] = equilibrium (balance, 0);
%! off = norm (balance.shape (q){1}(end,:) - elastica (0.3));
%! body = struct ("V", q(1:end-3), "phi", q(end-2), "phi_dot", 0, "x", q(end-1), "y", q(end));
%! found = dropped_of_bodies (scene, mechanism, struct ("t", 0, "lambda", lambda, "bodies", body));
%! assert (off, 1.28e-3, 0.01e-3); assert (found.bound, off, 0.15*off);
%!test # a curved rod's bound, too: that of the rod alone
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1, "curvature", 2), ...
%!                        "model", struct ("modes", [1 2]))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%! scene.duration = 1;
%! scene = check_mechanism (scene);
%! mechanism = build_mechanism (scene, mechanism_rungs (scene, 0));
%! V = [1e-5; 0.01; 0.002]*[0 1];
%! history = struct ("t", [0 1], "lambda", zeros (2), ...
%!                   "bodies", struct ("V", V, "phi", [0 0], "phi_dot", [0 0], "x", [0 0], "y", [0 0]));
%! found = dropped_of_bodies (scene, mechanism, history);
%! assert (found.bound, bound_of_curved (mechanism.models{1}, V, 1)); assert (found.bound > 1e-5);
