## -*- texinfo -*-
## @deftypefn {} {@var{linear} =} linearised_motion (@var{balance}, @var{t}, @var{q}, @var{v})
## The equations of a @var{balance} (see @code{mechanism_at_rest}) linear about the state @var{q}, @var{v} (n-by-1) of
## a motion at the time @var{t} (s), their coefficients frozen there: a struct as of @code{linearised}.
##
## What is near the motion is off it by Z y, Z (n-by-p) what the constraints leave free, which moves with them: of all
## such Z the one that turns least, Phi_q Z = 0 and Z' Z_dot = 0.  Then, with K and C minus the derivatives by q and v
## of the forces less inertia,
##
## @example
## Z' (M Z y'' + (C Z + 2 M Z_dot) y' + (K Z + C Z_dot + M Z_ddot) y) = 0.
## @end example
## @end deftypefn

function linear = linearised_motion (balance, t, q, v)
  [a, lambda] = balance.accelerations (t, q, v);
  n = balance.n;
  steps = 1e-4*balance.length./arrayfun (@(k) balance.size ((1:n).' == k), (1:n).');
  linear.stiffness = -difference_quotients (@(x) balance.moving (t, q + x, v + 0*x, a + 0*x, lambda), steps);
  C = -difference_quotients (@(x) balance.moving (t, q + 0*x, v + x, a + 0*x, lambda), steps);
  linear.mass = balance.mass (q);
  [linear.jacobian, rate, second] = jacobian_along (balance, q, v, a);
  Z = eye (n);
  if (balance.multipliers > 0)
    Z = null (linear.jacobian);
  endif
  back = -inverse_of (linear.jacobian);
  Z_dot = back*rate*Z;
  Z_ddot = back*(2*rate*Z_dot + second*Z) - Z*(Z_dot.'*Z_dot);  # so that Z' Z_dot stays 0
  linear.basis = Z;
  linear.M = Z.'*linear.mass*Z;
  linear.C = Z.'*(C*Z + 2*linear.mass*Z_dot);
  linear.K = Z.'*(linear.stiffness*Z + C*Z_dot + linear.mass*Z_ddot);
endfunction

## and its first and second rate on the way: in the time in which a point goes a thousandth of a rod
function [J, rate, second] = jacobian_along (balance, q, v, a)
  h = 1e-3/max ([balance.size(v)/balance.length, sqrt(balance.size (a)/balance.length), realmin]);
  at = @(s) balance.jacobian (q + s*v + s^2/2*a);
  J = at (0);
  [back, ahead] = deal (at (-h), at (h));
  rate = (ahead - back)/(2*h);
  second = (ahead - 2*J + back)/h^2;
endfunction

%!function [balance, q, v, scene] = swinging (scene, phi, phi_dot)   # a mechanism of one body at its start
%!  scene.bodies{1}.initial = struct ("phi", phi, "phi_dot", phi_dot);
%!  scene.duration = 1;
%!  scene = check_mechanism (scene);
%!  mechanism = build_mechanism (scene, mechanism_rungs (scene, 0));
%!  balance = mechanism_at_rest (scene, mechanism);
%!  [q, v] = placed_bodies (scene, mechanism);
%!endfunction
%!test # a rigid pendulum on its way, hung off its O: I phi'' = -m g a cos (phi), however fast it is
%! scene.bodies = {struct("rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3), "model", ...
%!                        struct ("modes", [0 0], "rotary_inertia", false))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0.4)};
%! [balance, q, v] = swinging (scene, -1, 5);
%! linear = linearised_motion (balance, 0, q, v);
%! inertia = 6*(2^2/12 + 0.6^2);
%! assert (linear.K/linear.M, 6*9.81*0.6*sin (1)/inertia, 1e-5); assert (linear.C/linear.M, 0, 1e-6);
%!test # at rest in equilibrium it is what is linear about that
%! [balance, q, v] = swinging (scene = struct ("bodies", {{struct("rod", struct ("length", 2, "EA", 1e5, "EI", 10, ...
%!   "rhoA", 3), "model", struct ("modes", [1 2], "rotary_inertia", false))}}, "joints", ...
%!   {{struct("kind", "revolute", "bodies", 1, "stations", 0)}}), -pi/2, 0);
%! [q, lambda] = equilibrium (balance, 0);
%! expected = vibrations (linearised (balance, 0, q, lambda));
%! assert (vibrations (linearised_motion (balance, 0, q, 0*q)).omega, expected.omega, -1e-6);
%!test # a rod in a hub at a steady speed, as Campbell's diagram has it: inextensible
%! scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 1), "model", ...
%!                        struct ("modes", "auto", "energy", "uniaxial", "rotary_inertia", false))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [4*t, 4, 0])};
%! [scene.gravity, scene.duration, scene.bodies{1}.initial.phi_dot] = deal (0, 1, 4);
%! scene = check_mechanism (scene);
%! mechanism = build_mechanism (scene, mechanism_rungs (scene, 16, 0));
%! balance = mechanism_at_rest (scene, mechanism);
%! [q, v] = placed_bodies (scene, mechanism);
%! modes = vibrations (linearised_motion (balance, 0, q, v));
%! flapping = [5.5850 24.2733];  # Wright, Smith, Thresher and Wang 1982
%! assert (modes.omega(1:2), sqrt (flapping.^2 - 4^2), 1e-2);
