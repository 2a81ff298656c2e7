## -*- texinfo -*-
## @deftypefn {} {@var{balance} =} rotating_balance (@var{scene}, @var{mechanism}, @var{speed}, @var{centre})
## The balance of forces of a checked scene's @var{mechanism} (see @code{mechanism_at_rest}) in the frame that turns at
## the @var{speed} (rad/s) about the @var{centre} ([x y], m), at t = 0, when it has the directions of the fixed one:
## what is at rest there has the velocities of that rotation, and the forces are less the inertia of its accelerations.
##
## Of the coordinates x, y, phi of a body with rates in that frame: phi_dot + speed, x_dot - speed (y - y_0), y_dot +
## speed (x - x_0), with accelerations -speed^2 (x - x_0) - 2 speed y_dot and -speed^2 (y - y_0) + 2 speed x_dot.
## @end deftypefn

function balance = rotating_balance (scene, mechanism, speed, centre)
  balance = mechanism_at_rest (scene, mechanism);
  system = mechanism_system (scene, mechanism);
  last = cellfun (@(body) body(end-2:end)(:), balance.bodies, "uniformoutput", false);
  last = [last{:}];  # phi, x, y, a column a body
  frame = struct ("phi", last(1,:), "x", last(2,:), "y", last(3,:), "speed", speed, "centre", centre);
  balance.residual = @(t, q, v, lambda) residual (system, frame, q, v, lambda);
  steps = 1e-4*balance.length*system.q_scale;
  forces = @(q, v, lambda) balance.residual (0, q, v, lambda);
  by_q = @(q, lambda) difference_quotients (@(x) forces (q + x, 0*x, lambda), steps);
  balance.tangent = @(t, q, lambda) stiffness (by_q (q, lambda), balance.n);
  balance.damping = @(t, q, lambda) -difference_quotients (@(x) forces (q + 0*x, x, lambda), steps)(1:balance.n,:);
endfunction

function r = residual (system, frame, q, v, lambda)
  across = q(frame.y,:) - frame.centre(2);
  along = q(frame.x,:) - frame.centre(1);
  a = 0*v;
  a(frame.x,:) = -frame.speed^2*along - 2*frame.speed*v(frame.y,:);
  a(frame.y,:) = -frame.speed^2*across + 2*frame.speed*v(frame.x,:);
  v(frame.phi,:) += frame.speed;
  v(frame.x,:) -= frame.speed*across;
  v(frame.y,:) += frame.speed*along;
  at = system.at (zeros (1, columns (q)), q, v);
  force = at.force - system.inertia (at, a) - system.reaction (at, repmat (lambda, 1, columns (q)));
  r = [force; at.constraints.residual];
endfunction

function K = stiffness (D, n)
  K = D;
  K(1:n,:) *= -1;
endfunction

%!test # a rigid rod that turns about its end pulls at it by m speed^2 l/2, and is pushed across by 2 m speed v
%! scene.bodies = {struct("rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3), "model", struct ("modes", [0 0]))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0, "point", [1 0])};
%! [scene.duration, scene.gravity] = deal (1, 0);
%! scene = check_mechanism (scene);
%! balance = rotating_balance (scene, build_mechanism (scene, mechanism_rungs (scene, 0)), 5, [1 0]);
%! assert (balance.start, [0; 1; 0]);
%! assert (balance.residual (0, balance.start, zeros (3, 1), zeros (2, 1)), [0; 6*25; 0; 0; 0], 1e-9);
%! assert (balance.damping (0, balance.start, zeros (2, 1))(3,2), 2*6*5, 1e-6);
