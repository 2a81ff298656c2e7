## -*- texinfo -*-
## @deftypefn {} {@var{balance} =} rotating_balance (@var{balance}, @var{speed}, @var{centre})
## The @var{balance} of a mechanism's forces (see @code{mechanism_at_rest}) in the frame that turns at the @var{speed}
## (rad/s) about the @var{centre} ([x y], m), at t = 0, when it has the directions of the fixed one: what is at rest
## there has the velocities of that rotation, and the forces are less the inertia of its accelerations.
## @end deftypefn

function balance = rotating_balance (balance, speed, centre)
  last = cellfun (@(body) body(end-2:end)(:), balance.bodies, "uniformoutput", false);
  last = [last{:}];  # phi, x, y, a column a body
  frame = struct ("speed", speed, "centre_x", centre(1), "centre_y", centre(2));
  balance.residual = @(t, q, v, lambda) residual (balance.moving, last, frame, q, v, lambda);
  balance = with_derivatives (balance, balance.steps);
endfunction

function r = residual (moving, last, frame, q, v, lambda)
  [phi, x, y] = deal (last(1,:), last(2,:), last(3,:));
  place = struct ("x", q(x,:), "y", q(y,:), "x_dot", v(x,:), "y_dot", v(y,:));
  a = 0*v;
  [v(x,:), v(y,:), a(x,:), a(y,:)] = rotating_place (place, frame);
  v(phi,:) += frame.speed;
  [force, off] = moving (0, q, v, a, lambda);
  r = [force; off];
endfunction

%!test # a rigid rod that turns about its end pulls at it by m speed^2 l/2, and is pushed across by 2 m speed v
%! scene.bodies = {struct("rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3), "model", struct ("modes", [0 0]))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0, "point", [1 0])};
%! [scene.duration, scene.gravity] = deal (1, 0);
%! scene = check_mechanism (scene);
%! balance = mechanism_at_rest (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%! balance = rotating_balance (balance, 5, [1 0]);
%! assert (balance.start, [0; 1; 0]);
%! assert (balance.residual (0, balance.start, zeros (3, 1), zeros (2, 1)), [0; 6*25; 0; 0; 0], 1e-9);
%! assert (balance.damping (0, balance.start, zeros (2, 1))(3,2), 2*6*5, 1e-6);
