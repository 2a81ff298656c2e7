## -*- texinfo -*-
## @deftypefn {} {@var{equations} =} exact_equations ()
## What a mechanism asks of bodies (see @code{matrix_equations}) that are geometrically exact rods by their strains (see
## maxima/rod/exact_line.mac): sums over the points of the model's line (see @code{line_points}).  Strain energy and
## damping are quadratic in the amplitudes, so that nothing that is stiff changes; places are integrals along the rod.
## phi is the angle of the frame in which they have no angular momentum about O, to the first order (see
## @code{curved_base}); rotary inertia is that of the tangent's turning.
## @end deftypefn

function equations = exact_equations ()
  equations.dynamics = @dynamics;
  equations.inertia = @inertia;
  equations.mass = @mass;
  equations.energies = @energies;
  equations.convection = @convection;
  equations.marker = @marker;
  equations.point = @point;
  equations.tangent = @tangent;
  equations.marker_convection = @marker_convection;
  equations.marker_stiffness = @marker_stiffness;
  equations.centreline = @centreline_of;
  equations.angle = @angle_of;
endfunction

## the fields of the line, and how it goes on (see rod_exact_line)
function at = along_line (line, motion)
  at.stretch = line.stretch*motion.V;
  at.angle = line.angle + motion.phi + line.turn*motion.V;
  at.stretch_dot = line.stretch*motion.V_dot;
  at.angle_dot = motion.phi_dot + line.turn*motion.V_dot;
  [at.x, at.y, at.x_dot, at.y_dot, at.x_convection, at.y_convection, at.by_stretch_x, at.by_stretch_y, ...
   at.by_angle_x, at.by_angle_y] = rod_exact_line (at);
endfunction

## that, and where the mass of the points is against O, its rate, and its second rate without those of the coordinates
function at = masses_along (line, motion)
  at = along_line (line, motion);
  [x, y, x_rate, y_rate, x_convection, y_convection, at.own_x, at.own_y, at.own_x_dot, at.own_y_dot] = ...
    rod_exact_offset (at, line.offset);
  at.mass_x = line.to_points*at.x + x;
  at.mass_y = line.to_points*at.y + y;
  at.mass_x_dot = line.to_points*at.x_dot + x_rate;
  at.mass_y_dot = line.to_points*at.y_dot + y_rate;
  at.mass_x_convection = line.to_points*at.x_convection + x_convection;
  at.mass_y_convection = line.to_points*at.y_convection + y_convection;
endfunction

## generalized forces (R-by-k) of forces and torques on the masses: beyond a place they pull on what is there
function f = on_coordinates (line, at, force_x, force_y, torque)
  torque += at.own_x.*force_x + at.own_y.*force_y;
  pull_x = line.to_points.'*force_x;
  pull_y = line.to_points.'*force_y;
  on_angle = at.by_angle_x.*pull_x + at.by_angle_y.*pull_y + torque;
  f = [line.stretch.'*(at.by_stretch_x.*pull_x + at.by_stretch_y.*pull_y) + line.turn.'*on_angle
       sum(on_angle, 1)
       sum(force_x, 1)
       sum(force_y, 1)];
endfunction

function [force, dissipated, at] = dynamics (model, motion, gravity)
  line = model.line;
  at = masses_along (line, motion);
  m = line.points.point_mass;
  force = -on_coordinates (line, at, m.*at.mass_x_convection, m.*(at.mass_y_convection + gravity), 0);
  damping = model.arrays.damping*model.arrays.stiffness_matrix*motion.V_dot;
  force(1:end-3,:) -= model.arrays.stiffness_matrix*motion.V + damping;
  dissipated = sum (motion.V_dot.*damping, 1);
endfunction

function product = inertia (model, at, a)
  line = model.line;
  stretch = line.stretch*a(1:end-3,:);
  angle = a(end-2,:) + line.turn*a(1:end-3,:);
  m = line.points.point_mass;
  x = m.*(a(end-1,:) + line.to_points*(at.by_stretch_x.*stretch + at.by_angle_x.*angle) + at.own_x.*angle);
  y = m.*(a(end,:) + line.to_points*(at.by_stretch_y.*stretch + at.by_angle_y.*angle) + at.own_y.*angle);
  product = on_coordinates (line, at, x, y, line.points.rotary_inertia.*angle);
endfunction

## column after column
function M = mass (model, at)
  k = columns (at.angle);
  R = columns (model.line.stretch) + 3;
  M = zeros (R, R, k);
  for j = 1:R
    unit = zeros (R, k);
    unit(j,:) = 1;
    M(:,j,:) = reshape (inertia (model, at, unit), R, 1, k);
  endfor
endfunction

function [T, U, Z] = energies (model, motion, gravity)
  line = model.line;
  at = masses_along (line, motion);
  at.bend = line.bend*motion.V;
  at.x_dot = motion.x_dot + at.mass_x_dot;
  at.y_dot = motion.y_dot + at.mass_y_dot;
  at.y = motion.y + at.mass_y;
  [T, U, Z] = rod_exact_energies (at, line.points, gravity);
  T = sum (T, 1);
  U = sum (U, 1);
  Z = sum (Z, 1);
endfunction

function f = convection (model, motion)
  line = model.line;
  at = masses_along (line, motion);
  m = line.points.point_mass;
  f = on_coordinates (line, at, m.*at.mass_x_convection, m.*at.mass_y_convection, 0);
  momentum_x = m.*(motion.x_dot + at.mass_x_dot);
  momentum_y = m.*(motion.y_dot + at.mass_y_dot);
  pull = struct ("pull_x", line.to_points.'*momentum_x, "pull_y", line.to_points.'*momentum_y);
  [stretch_angle, angle_angle] = rod_exact_line_tangent (at, pull);
  on_angle = stretch_angle.*at.stretch_dot + angle_angle.*at.angle_dot ...
             + momentum_x.*at.own_x_dot + momentum_y.*at.own_y_dot;
  f(1:end-2,:) += [line.stretch.'*(stretch_angle.*at.angle_dot) + line.turn.'*on_angle; sum(on_angle, 1)];
endfunction

function marker = marker (model, station)
  f = curved_functions (model.base, model.base.axis, station);
  [~, ~, direction] = undeformed_places (model.base, station);
  marker = struct ("line", model.line, "direction", direction, "turn", f.chi.', ...
                   "to_point", [integrals_to(model.line.axis, station), 0].');
endfunction

function [x, y, x_dot, y_dot, x_phi, y_phi, x_V, y_V] = point (motion, marker)
  line = marker.line;
  at = along_line (line, motion);
  to = marker.to_point.';
  x = motion.x + to*at.x;
  y = motion.y + to*at.y;
  x_dot = motion.x_dot + to*at.x_dot;
  y_dot = motion.y_dot + to*at.y_dot;
  x_phi = to*at.by_angle_x;
  y_phi = to*at.by_angle_y;
  stretch = line.stretch.'.*to;
  turn = line.turn.'.*to;
  x_V = stretch*at.by_stretch_x + turn*at.by_angle_x;
  y_V = stretch*at.by_stretch_y + turn*at.by_angle_y;
endfunction

function [angle, angle_dot, angle_V] = tangent (motion, marker)
  angle = motion.phi + marker.direction + marker.turn.'*motion.V;
  angle_dot = motion.phi_dot + marker.turn.'*motion.V_dot;
  angle_V = marker.turn*ones (size (motion.phi));
endfunction

function [x, y, angle] = marker_convection (motion, marker)
  at = along_line (marker.line, motion);
  x = marker.to_point.'*at.x_convection;
  y = marker.to_point.'*at.y_convection;
  angle = 0*motion.phi;
endfunction

function [phi_phi, phi_V, V_V] = marker_stiffness (motion, loads, marker)
  line = marker.line;
  at = along_line (line, setfield (setfield (motion, "V_dot", 0*motion.V), "phi_dot", 0*motion.phi));
  pull = struct ("pull_x", marker.to_point*loads.force_x, "pull_y", marker.to_point*loads.force_y);
  [stretch_angle, angle_angle] = rod_exact_line_tangent (at, pull);
  phi_phi = sum (angle_angle, 1);
  phi_V = line.stretch.'*stretch_angle + line.turn.'*angle_angle;
  n = columns (line.turn);
  products = @(f, g) reshape (permute (f, [2 3 1]).*permute (g, [3 2 1]), n*n, rows (f));
  V_V = (products (line.stretch, line.turn) + products (line.turn, line.stretch))*stretch_angle ...
        + products (line.turn, line.turn)*angle_angle;
endfunction

## deformed from where the undeformed rod has its ends, but for one whose ends meet, so that drawn rods meet at joints
function [x, y] = centreline_of (model, stations, motion, zoom)
  none = struct ("V", 0*motion.V, "V_dot", 0*motion.V, "phi", motion.phi, "phi_dot", 0*motion.phi);
  to = [integrals_to(model.line.axis, [stations(:); model.length]), zeros(numel (stations) + 1, 1)];
  places = @(at) to*(at.x + 1i*at.y);
  deformed = places (along_line (model.line, setfield (none, "V", motion.V)));
  from = places (along_line (model.line, none));
  if (abs (from(end,1)) > model.length/10)
    from .*= deformed(end,:)./from(end,:);
  endif
  drawn = (from + zoom*(deformed - from))(1:end-1,:);
  x = real (drawn);
  y = imag (drawn);
endfunction

function psi = angle_of (model, station, phi, V)
  there = marker (model, station);
  psi = phi + there.direction + there.turn.'*V;
endfunction

%!function [model, motion, gravity] = bent_rod (curvature)   # in two states
%!  body.rod = struct ("length", 1.5, "EA", 300, "EI", 2, "rhoA", 0.7, "rhoI", 0.01, "damping", 0.03, ...
%!                     "curvature", curvature, "curvature_breaks", [], "half_height", [], "width", []);
%!  body.tip_mass = 0.4;
%!  body.model = struct ("energy", "uniaxial", "rotary_inertia", true);
%!  model = free_rod_model (body, struct ("sines", [2 3], "stiffening", "exact"));
%!  at = @(s) sin ((1:8).'*[1 2] + s)/2;
%!  motion = motion_of_rods (at (0), at (1));
%!  gravity = 9.81;
%!endfunction
%!test # a rigid one, and a pull on it
%! rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 3, "rhoI", 0, "damping", 0, "curvature", [], "curvature_breaks", []);
%! body = struct ("rod", rod, "tip_mass", 0, "model", struct ("energy", "uniaxial", "rotary_inertia", true));
%! model = free_rod_model (body, struct ("sines", [0 0], "stiffening", "exact"));
%! motion = motion_of_rods ([0.3 0; 1 2; 0 0], [1 0; 0 0; 0 0]);
%! loads = struct ("force_x", [2 3], "force_y", [0 0], "force_angle", [0 0]);
%! [phi_phi, phi_V, V_V] = model.equations.marker_stiffness (motion, loads, model.equations.marker (model, 1));
%! assert (phi_phi, -[2 3].*cos ([0.3 0]), 1e-14); assert ({size(phi_V), size(V_V)}, {[0 2], [0 2]});
%! [T, U] = model.equations.energies (model, motion, 0);
%! assert (T, [0.5 0], 1e-14); assert (U, [0 0]);
%!function q = coordinates (motion)
%!  q = [motion.V; motion.phi; motion.x; motion.y];
%!endfunction
%!function d = by_differences (f, motion)   # of f's rows by each coordinate: coordinates-by-states, of one row
%!  q = coordinates (motion);
%!  v = [motion.V_dot; motion.phi_dot; motion.x_dot; motion.y_dot];
%!  for j = 1:rows (q)
%!    step = 1e-5*((1:rows (q)).' == j);
%!    d(j,:) = (f (motion_of_rods (q + step, v)) - f (motion_of_rods (q - step, v)))/2e-5;
%!  endfor
%!endfunction
%!function v = rates (motion)
%!  v = [motion.V_dot; motion.phi_dot; motion.x_dot; motion.y_dot];
%!endfunction
%!function [T, potential] = energies_of (model, motion, gravity)
%!  [T, U, Z] = model.equations.energies (model, motion, gravity);
%!  potential = U + Z;
%!endfunction
%!test # T is v.M.v/2, the forces are what energies have as derivatives, less what dampers take: straight and curved
%! for curvature = {[], 1.1}
%!   [model, motion, gravity] = bent_rod (curvature{1});
%!   [force, dissipated, d] = model.equations.dynamics (model, motion, gravity);
%!   v = rates (motion);
%!   M = model.equations.mass (model, d);
%!   product = model.equations.inertia (model, d, v);
%!   assert ([M(:,:,1)*v(:,1), M(:,:,2)*v(:,2)], product, 1e-12);
%!   assert (permute (M, [2 1 3]), M, 1e-12);
%!   assert (energies_of (model, motion, gravity), sum (v.*product, 1)/2, 1e-12);
%!   T_q = by_differences (@(m) energies_of (model, m, gravity), motion);
%!   U_q = by_differences (@(m) nthargout (2, @energies_of, model, m, gravity), motion);
%!   damping = [0.03*model.arrays.stiffness_matrix*motion.V_dot; zeros(3, 2)];
%!   assert (force + model.equations.convection (model, motion), T_q - U_q - damping, 1e-7);
%!   assert (dissipated, sum (v.*damping, 1), 1e-12);
%! endfor
%!test # a point and the tangent there: derivatives, rates, and the stiffness of a pull
%! for curvature = {[], 1.1}
%!   [model, motion] = bent_rod (curvature{1});
%!   of = model.equations;
%!   marker = of.marker (model, 1.1);
%!   [x, y, x_dot, y_dot, x_phi, y_phi, x_V, y_V] = of.point (motion, marker);
%!   x_q = by_differences (@(m) of.point (m, marker), motion);
%!   y_q = by_differences (@(m) nthargout (2, of.point, m, marker), motion);
%!   assert ([x_V; x_phi; 1 1; 0 0], x_q, 1e-9);
%!   assert ([y_V; y_phi; 0 0; 1 1], y_q, 1e-9);
%!   assert ([x_dot; y_dot], [sum(x_q.*rates (motion), 1); sum(y_q.*rates (motion), 1)], 1e-9);
%!   [angle, angle_dot, angle_V] = of.tangent (motion, marker);
%!   assert ([angle_V; 1 1; 0 0; 0 0], by_differences (@(m) of.tangent (m, marker), motion), 1e-9);
%!   assert (angle_dot, sum ([angle_V; 1 1].*rates (motion)(1:end-2,:), 1), 1e-12);
%!   assert (angle, of.angle (model, 1.1, motion.phi, motion.V), 1e-12);
%!   [from_x, from_y] = of.centreline (model, 1.1, motion, 1);
%!   assert ([from_x + motion.x; from_y + motion.y], [x; y], 1e-12);
%!   [x_c, y_c, angle_c] = of.marker_convection (motion, marker);
%!   later = motion_of_rods (coordinates (motion) + 1e-5*rates (motion), rates (motion));
%!   sooner = motion_of_rods (coordinates (motion) - 1e-5*rates (motion), rates (motion));
%!   rate = @(k) (nthargout (k, of.point, later, marker) - nthargout (k, of.point, sooner, marker))/2e-5;
%!   assert ([x_c; y_c; angle_c], [rate(3); rate(4); 0 0], 1e-7);
%!   loads = struct ("force_x", [2 3], "force_y", [-1 5], "force_angle", [7 7]);
%!   [phi_phi, phi_V, V_V] = of.marker_stiffness (motion, loads, marker);
%!   work = @(m) nthargout (5:8, of.point, m, marker);
%!   on_phi = @(w) loads.force_x.*w{1} + loads.force_y.*w{2};
%!   on_2 = @(w) loads.force_x.*w{3}(2,:) + loads.force_y.*w{4}(2,:);
%!   assert ([phi_V; phi_phi; 0 0; 0 0], by_differences (@(m) on_phi (work (m)), motion), 1e-7);
%!   assert (reshape (V_V, 5, 5, 2)(:,2,:)(:), by_differences (@(m) on_2 (work (m)), motion)(1:5,:)(:), 1e-7);
%! endfor
%!test # its ends are drawn where they are, whatever the zoom; straight between them without deformation
%! for curvature = {[], 1.1}
%!   [model, motion] = bent_rod (curvature{1});
%!   for zoom = [0 1 7]
%!     [x, y] = model.equations.centreline (model, [0 1.5], motion, zoom);
%!     ends(:,:,zoom+1) = [x; y];
%!   endfor
%!   assert (ends(:,:,[1 8]), ends(:,:,[2 2]), 1e-13); assert (ends([1 3],:,1), zeros (2));
%! endfor
%! [model, motion] = bent_rod ([]);
%! [x, y] = model.equations.centreline (model, [0.5 1.5], motion, 0);
%! assert ([x(1,:); y(1,:)], [x(2,:); y(2,:)]/3, 1e-14);
%!test # a ring, whose ends meet, is drawn about its own frame
%! [model, motion] = bent_rod (2*pi/1.5);
%! [x, y] = model.equations.centreline (model, [0 1.5], motion, 0);
%! assert ([x, y], zeros (2, 4), 1e-12);
