## -*- texinfo -*-
## @deftypefn {} {@var{forces} =} joint_forces (@var{mechanism}, @var{at}, @var{lambda})
## What each joint does to its first body where it holds it, in the states that @var{at} came from (see
## @code{mechanism_system}) with the multipliers @var{lambda} (constraints-by-m): a struct array of reaction_x,
## reaction_y (1-by-m, N) and torque (N m), of its constraints and its springs together; zeros of a load.
## @end deftypefn

function forces = joint_forces (mechanism, at, lambda)
  of.x = of.y = of.angle = zeros (rows (mechanism.marker_of), columns (lambda));
  of = without_pull (of, mechanism.constraints, at.constraints, lambda);
  of = without_pull (of, mechanism.springs, at.springs, at.springs.tension);
  forces = struct ("reaction_x", num2cell (of.x, 2), "reaction_y", num2cell (of.y, 2), ...
                   "torque", num2cell (of.angle, 2)).';
endfunction

## each form of constraint has its joints once, and their first bodies' coordinates first
function of = without_pull (of, constraints, c, lambda)
  for i = 1:numel (c.gradients)
    kind = constraints.kinds(i);
    for coordinate = kind.coordinates(kind.coordinates <= 3)
      part = {"x", "y", "angle"}{coordinate};
      of.(part)(kind.joints,:) -= c.gradients{i}{coordinate}.*lambda(kind.rows,:);
    endfor
  endfor
endfunction

%!test # of revolute joints the multipliers themselves, of a spring its tension along it, of a load nothing
%! [system, q, v] = sample_state ();
%! at = system.at ([0 0], [q q], [v 0*v]);
%! lambda = reshape (1:10, 5, 2);
%! forces = joint_forces (system.mechanism, at, lambda);
%! assert ([forces(2).reaction_x; forces(2).reaction_y; forces(2).torque], [-lambda(3:4,:); 0 0], 1e-12);
%! spring = find (system.mechanism.springs.joint == 5);
%! pull = hypot (forces(5).reaction_x, forces(5).reaction_y);
%! assert (pull, abs (at.springs.tension(spring,:)), 1e-12);
%! assert (forces(4).torque, -at.springs.tension(3-spring,:), 1e-12);
%! assert (struct2cell (forces(6)), {[0 0]; [0 0]; [0 0]});
%!test # power of what the joints do between their bodies is that of the generalized forces
%! [system, q, v] = sample_state ();
%! v = project_velocities (system, 0, q, v);
%! at = system.at (0, q, v);
%! lambda = [1; 2; 3; -4; 0];
%! forces = joint_forces (system.mechanism, at, lambda);
%! power = 0;
%! for j = 1:5
%!   k = system.mechanism.marker_of(j,:);
%!   rate = @(of) at.markers.(of)(k(1)) - at.markers.(of)(k(2));
%!   power += forces(j).reaction_x*rate ("x_dot") + forces(j).reaction_y*rate ("y_dot") ...
%!            + forces(j).torque*rate ("angle_dot");
%! endfor
%! assert (power, -(system.spring_reaction (at, at.springs.tension) + system.reaction (at, lambda)).'*v, 1e-10);
