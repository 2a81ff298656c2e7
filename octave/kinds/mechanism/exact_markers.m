## -*- texinfo -*-
## @deftypefn {} {@var{equations} =} exact_markers ()
## Points of geometrically exact rods and the tangents there, of what a mechanism asks of bodies (see
## @code{matrix_equations}): marker, point, tangent, marker_convection, marker_stiffness, centreline and angle.
## @end deftypefn

function equations = exact_markers ()
  equations.marker = @marker;
  equations.point = @point;
  equations.tangent = @tangent;
  equations.marker_convection = @marker_convection;
  equations.marker_stiffness = @marker_stiffness;
  equations.centreline = @centreline_of;
  equations.angle = @angle_of;
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

%!test # a point and the tangent there: derivatives, rates, and the stiffness of a pull
%! for curvature = {[], 1.1}
%!   [model, motion] = sample_exact_rod (curvature{1});
%!   of = model.equations;
%!   marker = of.marker (model, 1.1);
%!   [x, y, x_dot, y_dot, x_phi, y_phi, x_V, y_V] = of.point (motion, marker);
%!   [x_q, q, v] = by_coordinates (@(m) of.point (m, marker), motion);
%!   y_q = by_coordinates (@(m) nthargout (2, of.point, m, marker), motion);
%!   assert ([x_V; x_phi; 1 1; 0 0], x_q, 1e-9);
%!   assert ([y_V; y_phi; 0 0; 1 1], y_q, 1e-9);
%!   assert ([x_dot; y_dot], [sum(x_q.*v, 1); sum(y_q.*v, 1)], 1e-9);
%!   [angle, angle_dot, angle_V] = of.tangent (motion, marker);
%!   assert ([angle_V; 1 1; 0 0; 0 0], by_coordinates (@(m) of.tangent (m, marker), motion), 1e-9);
%!   assert (angle_dot, sum ([angle_V; 1 1].*v(1:end-2,:), 1), 1e-12);
%!   assert (angle, of.angle (model, 1.1, motion.phi, motion.V), 1e-12);
%!   [from_x, from_y] = of.centreline (model, 1.1, motion, 1);
%!   assert ([from_x + motion.x; from_y + motion.y], [x; y], 1e-12);
%!   [x_c, y_c, angle_c] = of.marker_convection (motion, marker);
%!   later = motion_of_rods (q + 1e-5*v, v);
%!   sooner = motion_of_rods (q - 1e-5*v, v);
%!   rate = @(k) (nthargout (k, of.point, later, marker) - nthargout (k, of.point, sooner, marker))/2e-5;
%!   assert ([x_c; y_c; angle_c], [rate(3); rate(4); 0 0], 1e-7);
%!   loads = struct ("force_x", [2 3], "force_y", [-1 5], "force_angle", [7 7]);
%!   [phi_phi, phi_V, V_V] = of.marker_stiffness (motion, loads, marker);
%!   work = @(m) nthargout (5:8, of.point, m, marker);
%!   on_phi = @(w) loads.force_x.*w{1} + loads.force_y.*w{2};
%!   on_2 = @(w) loads.force_x.*w{3}(2,:) + loads.force_y.*w{4}(2,:);
%!   assert ([phi_V; phi_phi; 0 0; 0 0], by_coordinates (@(m) on_phi (work (m)), motion), 1e-7);
%!   assert (reshape (V_V, 5, 5, 2)(:,2,:)(:), by_coordinates (@(m) on_2 (work (m)), motion)(1:5,:)(:), 1e-7);
%! endfor
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
%!test # its ends are drawn where they are, whatever the zoom; straight between them without deformation
%! for curvature = {[], 1.1}
%!   [model, motion] = sample_exact_rod (curvature{1});
%!   for zoom = [0 1 7]
%!     [x, y] = model.equations.centreline (model, [0 1.5], motion, zoom);
%!     ends(:,:,zoom+1) = [x; y];
%!   endfor
%!   assert (ends(:,:,[1 8]), ends(:,:,[2 2]), 1e-13); assert (ends([1 3],:,1), zeros (2));
%! endfor
%! [model, motion] = sample_exact_rod ([]);
%! [x, y] = model.equations.centreline (model, [0.5 1.5], motion, 0);
%! assert ([x(1,:); y(1,:)], [x(2,:); y(2,:)]/3, 1e-14);
%!test # a ring, whose ends meet, is drawn about its own frame
%! [model, motion] = sample_exact_rod (2*pi/1.5);
%! [x, y] = model.equations.centreline (model, [0 1.5], motion, 0);
%! assert ([x, y], zeros (2, 4), 1e-12);
