## -*- texinfo -*-
## @deftypefn {} {@var{along} =} section_forces (@var{system}, @var{scene}, @var{t}, @var{q}, @var{lambda})
## Forces and moments in the sections of the rods of a checked scene's mechanism (see @code{mechanism_system}) at rest
## at the time @var{t} (s) with coordinates @var{q} (n-by-1) and multipliers @var{lambda}: a cell array, a body each,
## of a struct of columns (41-by-1): N and Q (N; along the rod and to the left of it), M (N m) and stress (Pa; NaN
## where it is not known, see @code{section_stress}).
##
## They are the resultants of weight, loads and joints beyond the section of the deformed rod, which these do to what
## lies before it: by equilibrium, whatever functions the rod has.  Where a force acts they are those just beyond it,
## at the tip those just before.
## @end deftypefn

function along = section_forces (system, scene, t, q, lambda)
  F = system.on_markers (system.at (t, q, 0*q), lambda);
  mechanism = system.mechanism;
  for k = 1:numel (mechanism.models)
    own = find (mechanism.marker_body == k);
    points = struct ("station", [mechanism.marker_station(own); mechanism.models{k}.length], ...
                     "x", [F.x(own); 0], "y", [F.y(own); -scene.bodies(k).tip_mass*scene.gravity], ...
                     "angle", [F.angle(own); 0]);
    motion = motion_of_rods (q(index_of (mechanism, k)), 0*q(index_of (mechanism, k)));
    along{k} = of_body (mechanism.models{k}, motion, points, scene.gravity);
    along{k}.stress = section_stress (scene.bodies(k).rod, stations_of (mechanism.models{k}), along{k});
  endfor
endfunction

function stations = stations_of (model)
  stations = linspace (0, model.length, 41).';
endfunction

function resultants = of_body (model, motion, points, gravity)
  l = model.length;
  stations = stations_of (model);
  [x, y] = body_centreline (model, stations, motion, 1);
  [x_i, y_i] = body_centreline (model, points.station, motion, 1);
  angle = arrayfun (@(station) model.equations.angle (model, station, motion.phi, motion.V), stations);
  beyond = points.station.' > stations | (stations == l & points.station.' == l);
  [weight, moment] = weights_beyond (model, motion, stations, x, gravity);
  X = beyond*points.x;
  Y = beyond*points.y + weight;
  resultants.N = X.*cos (angle) + Y.*sin (angle);
  resultants.Q = Y.*cos (angle) - X.*sin (angle);
  resultants.M = beyond*(x_i.*points.y - y_i.*points.x + points.angle) - x.*(Y - weight) + y.*X + moment;
endfunction

## what weighs beyond each station, and its moment about the centreline there
function [weight, moment] = weights_beyond (model, motion, stations, x, gravity)
  [nodes, parts] = gauss_rule (6);
  inside = stations(1:end-1).' + nodes(:)*diff (stations).';
  weights = -gravity*model.section.rhoA*parts(:)*diff (stations).';
  places = reshape (body_centreline (model, inside(:), motion, 1), size (inside));
  from_here = @(panels) [flipud(cumsum (flipud (sum (panels, 1).'))); 0];
  weight = from_here (weights);
  moment = from_here (weights.*places) - x.*weight;
endfunction

%!function [along, found] = resting (scene)
%!  found = at_rest (mechanism_kind (), scene, 0, @(found) vertcat (found.balance.shape (found.q){:})(:).');
%!  along = found.balance.along (0, found.q, found.lambda);
%!endfunction
%!function along = resting_rod (scene)
%!  along = resting (check_mechanism (scene_at_rest (scene))){1};
%!endfunction
%!function scene = rod_of (varargin)
%!  scene = struct ("gravity", 0, "duration", 1, "joints", {varargin});
%!  scene.rod = struct ("length", 2, "width", 0.02, "half_height", 0.05, "lambda", 0, "mu", 1e9, "density", 500);
%!  scene.model = struct ("modes", "auto", "energy", "uniaxial");
%!endfunction
%!test # a cantilever under a small force at its tip, across it and along it; stress of both
%! clamp = struct ("kind", "angle", "stations", 0, "value", 0);
%! push = struct ("kind", "force", "stations", 2, "value", [0.3 -0.4]);
%! along = resting_rod (rod_of (clamp, push));
%! s = linspace (0, 2, 41).';
%! assert (along.N, 0.3*ones (41, 1), 1e-3); assert (along.Q, -0.4*ones (41, 1), 1e-3);
%! assert (along.M, -0.4*(2 - s), 1e-3);
%! assert (along.stress, abs (along.N)/0.002 + abs (along.M)*3/(2*0.02*0.05^2), 1e-9);
%!test # a rod that hangs bears what hangs below
%! scene = setfield (setfield (rod_of (), "gravity", 10), "initial", struct ("phi", -pi/2));
%! along = resting_rod (setfield (scene, "tip_mass", 3));
%! assert (along.N, 10*(1*(2 - linspace (0, 2, 41).') + 3), 1e-6); assert ([along.Q, along.M], zeros (41, 2), 1e-6);
%!test # supported at both ends: M = w s (l - s)/2 of its weight, and P s/2 up to a force at mid-span
%! guide = struct ("kind", "slider", "stations", 2, "point", [0 0], "direction", 0);
%! s = linspace (0, 2, 41).';
%! along = resting_rod (setfield (rod_of (guide), "gravity", 10));
%! assert (along.M, 10*s.*(2 - s)/2, 1e-4); assert (along.Q, -10*(1 - s), 1e-3);
%! push = struct ("kind", "force", "stations", 1, "value", [0 -8]);
%! along = resting_rod (rod_of (guide, push));
%! assert (along.M, 4*min (s, 2 - s), 1e-4); assert (along.Q, 4*(2*(s >= 1) - 1), 1e-4);
%!test # the flat roof: the bars' thrust bears the force
%! scene = flat_roof ();
%! scene.joints(end).value = @(t) [0 -1];
%! [along, found] = resting (scene);
%! down = found.balance.shape (found.q){1}(end,2);
%! assert (along{1}.N, -1/2*hypot (down, cos (0.2))/down*ones (41, 1), 1e-9);
%! assert ([along{1}.Q, along{1}.M], zeros (41, 2), 1e-9); assert (along{2}.N, along{1}.N, 1e-9);
%!test # a quarter circle, clamped, under a force down at its tip: M = -F R cos (angle), Winkler's stress
%! scene = rod_of (struct ("kind", "angle", "stations", 0, "value", 0), ...
%!                 struct ("kind", "force", "stations", pi/2, "value", [0 -1]));
%! [scene.rod.length, scene.rod.curvature, scene.initial.phi] = deal (pi/2, 1, atan2 (pi/2 - 1, 1));
%! along = resting_rod (scene);
%! angle = linspace (0, pi/2, 41).';
%! assert (along.M, -(1 - sin (angle)), 1e-3); assert (along.N, -sin (angle), 1e-3);
%! assert (along.Q, -cos (angle), 1e-3);
%! neutral = 0.1/log (1.05/0.95);  # where the clamped section, with the moment -1 alone, bears nothing
%! assert (along.stress(1), (neutral - 0.95)/(0.1*0.02*(1 - neutral)*0.95), -3e-3);
