## -*- texinfo -*-
## @deftypefn {} {@var{forces} =} joint_forces (@var{mechanism}, @var{at}, @var{lambda})
## What each joint does to its first body where it holds it, in the states that @var{at} came from (see
## @code{mechanism_system}) with the multipliers @var{lambda} (constraints-by-m): a struct array of reaction_x,
## reaction_y (1-by-m, N) and torque (N m), of its constraints and its springs together; zeros of a load.
## @end deftypefn

function forces = joint_forces (mechanism, at, lambda)
  forces = struct ("reaction_x", {}, "reaction_y", {}, "torque", {});
  for j = 1:rows (mechanism.marker_of)
    first = mechanism.marker_of(j,1);
    tie = reactions (mechanism, mechanism.constraints, at.constraints, of_joint (mechanism.constraints, j, lambda));
    pull = reactions (mechanism, mechanism.springs, at.springs, of_joint (mechanism.springs, j, at.springs.tension));
    both = @(part) -tie.(part)(first,:) - pull.(part)(first,:);
    forces(j) = struct ("reaction_x", both ("x"), "reaction_y", both ("y"), "torque", both ("angle"));
  endfor
endfunction

function own = of_joint (constraints, j, all)
  own = 0*all;
  own(constraints.joint == j,:) = all(constraints.joint == j,:);
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
