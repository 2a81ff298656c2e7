## -*- texinfo -*-
## @deftypefn {} {@var{equations} =} exact_equations ()
## What a mechanism asks of bodies (see @code{matrix_equations}) that are geometrically exact rods by their strains (see
## maxima/rod/exact_line.mac): sums over the points of the model's line (see @code{line_points}).  Strain energy and
## damping are quadratic in the amplitudes, so that nothing that is stiff changes; places are integrals along the rod.
## phi is the angle of the frame in which they have no angular momentum about O, to the first order (see
## @code{curved_base}); rotary inertia is that of the tangent's turning.
## @end deftypefn

function equations = exact_equations ()
  equations = exact_markers ();
  equations.dynamics = @dynamics;
  equations.inertia = @inertia;
  equations.mass = @mass;
  equations.energies = @energies;
  equations.convection = @convection;
endfunction

## the fields of the line, and where the masses of its points are against O, their rates, and their second rates without
## those of the coordinates
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

%!function [T, potential] = energies_of (model, motion, gravity)
%!  [T, U, Z] = model.equations.energies (model, motion, gravity);
%!  potential = U + Z;
%!endfunction
%!test # T is v.M.v/2, the forces are what energies have as derivatives, less what dampers take: straight and curved
%! for curvature = {[], 1.1}
%!   [model, motion, gravity] = sample_exact_rod (curvature{1});
%!   [force, dissipated, d] = model.equations.dynamics (model, motion, gravity);
%!   [~, ~, v] = by_coordinates (@(m) 0*m.phi, motion);
%!   M = model.equations.mass (model, d);
%!   product = model.equations.inertia (model, d, v);
%!   assert ([M(:,:,1)*v(:,1), M(:,:,2)*v(:,2)], product, 1e-12);
%!   assert (permute (M, [2 1 3]), M, 1e-12);
%!   assert (energies_of (model, motion, gravity), sum (v.*product, 1)/2, 1e-12);
%!   T_q = by_coordinates (@(m) energies_of (model, m, gravity), motion);
%!   U_q = by_coordinates (@(m) nthargout (2, @energies_of, model, m, gravity), motion);
%!   damping = [0.03*model.arrays.stiffness_matrix*motion.V_dot; zeros(3, 2)];
%!   assert (force + model.equations.convection (model, motion), T_q - U_q - damping, 1e-7);
%!   assert (dissipated, sum (v.*damping, 1), 1e-12);
%! endfor
