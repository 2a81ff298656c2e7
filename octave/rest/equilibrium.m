## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{lambda}, @var{linear}] =} equilibrium (@var{balance}, @var{t}, @var{q})
## Where a @var{balance} of forces (see @code{mechanism_at_rest}) holds at rest under the loads at the time @var{t}
## (s): coordinates near @var{q} (n-by-1; default: the start), multipliers, and the equations linear about it (see
## @code{linearised}).
##
## Newton's iteration that falls: of each mode of the tangent stiffness the force is divided by its modulus (Dauphin et
## al. 2014, "saddle-free"), so that it comes to rest where the potential energy is least, but stays where nothing
## pulls; a step moves a point by a twentieth of the longest rod at most, or of what all rods extend over at the start,
## and ends before forces along it turn back by more than they were.  One that does not converge is an error: in 3000
## steps, since what is stiff turns by short ones, or where these have gone ten times the longest rod or that extent.
## @end deftypefn

function [q, lambda, linear] = equilibrium (balance, t, q = balance.start)
  n = balance.n;
  lambda = zeros (balance.multipliers, 1);
  farthest = balance.length/20;
  if (isfield (balance, "shape"))
    farthest = max (farthest, norm (range (vertcat (balance.shape (balance.start){:}), 1))/20);
  endif
  smallest = Inf;
  gone = apart = 0;
  for sweep = 1:3000
    r = balance.residual (t, q, 0*q, lambda);
    if (! all (isfinite (r)))
      why = ": its forces are no numbers, as where a spring's points coincide";
      break;
    endif
    apart = max ([0; abs(r(n+1:end,1))]);
    linear = held_tangent (balance, t, q, lambda);
    onto = -inverse_of (linear.jacobian)*r(n+1:end,1);
    force = linear.basis.'*(r(1:n) - linear.stiffness*onto);
    step = onto + linear.basis*falling_step (linear.K, linear.M, force);
    metres = balance.size (step);
    share = unopposed_share (balance, t, q, lambda, step, min (1, farthest/metres));
    q += share*step;
    lambda += inverse_of (linear.jacobian).'*(r(1:n) - linear.stiffness*step);
    if (metres < 1e-13*balance.length || (metres < 1e-8*balance.length && metres >= smallest/2) ...
        || (smallest < 1e-7*balance.length && metres > smallest))
      if (apart <= 1e-6*balance.length)
        linear = linearised (balance, t, q, lambda);
        return;
      endif
      break;
    endif
    smallest = min (smallest, metres);
    gone += share*metres;
    why = sprintf (" in %d steps: the last one moved a point by %.2g m", sweep, share*metres);
    if (gone > 200*farthest)
      why = sprintf ("%s, all together by %.2g m: loads that turn it for ever have none", why, gone);
      break;
    endif
  endfor
  if (apart > 1e-6*balance.length)
    why = sprintf (": its joints stay apart by %.3g m (or rad), as those of a loop that does not close", apart);
  endif
  error ("toolchain:scene:equilibrium", ...
         "no equilibrium was found%s; place the bodies nearer to it, or take smaller loads\n", why);
endfunction

%!function balance = pendulum (angle, varargin)   # rigid, 2 m
%!  scene.bodies = {struct("rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3), "model", ...
%!                         struct ("modes", [0 0], "rotary_inertia", false), "initial", struct ("phi", angle))};
%!  scene.joints = [{struct("kind", "revolute", "bodies", 1, "stations", 0)}, varargin];
%!  scene.duration = 1;
%!  scene = check_mechanism (scene);
%!  balance = mechanism_at_rest (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%!endfunction
%!test # from the side it falls until it hangs, upright it stands; the hinge bears its weight
%! [q, lambda] = equilibrium (pendulum (0), 0);
%! assert (q(1), -pi/2, 1e-9); assert (lambda, [0; -6*9.81], 1e-7);
%! [q, ~, linear] = equilibrium (pendulum (pi/2), 0);
%! assert (q(1), pi/2, 1e-9); assert (linear.K < 0);
%!error <no equilibrium was found: its forces are no numbers, as where a spring's points coincide; place the bodies>
%! spring = struct ("kind", "spring", "bodies", 1, "stations", 1, "point", [1 0], "stiffness", 3);
%! equilibrium (pendulum (0, spring), 0);
%!error <no equilibrium was found: its joints stay apart by .* m .or rad., as those of a loop that does not close>
%! equilibrium (pendulum (0, struct ("kind", "revolute", "bodies", 1, "stations", 2, "point", [3 0])), 0);
%!test # a moment at its hinge holds it aslant: M = m g l/2 cos (phi)
%! moment = struct ("kind", "moment", "bodies", 1, "stations", 0, "value", 6*9.81*cosd (60));
%! assert (equilibrium (pendulum (-0.5, moment), 0)(1), -pi/3, 1e-9);
%!test # fourteen links fall from the horizontal
%! scene = check_mechanism (chain (14));
%! balance = mechanism_at_rest (scene, mechanism_kind ().build (scene, mechanism_kind ().stated (scene)));
%! assert (balance.shape (equilibrium (balance, 0)){14}(end,:), [0 -1.4], 1e-9);
%!error <in 2\d\d steps: the last one moved a point by 0.\d* m, all together by 20 m: loads that turn it for ever> # one that is too large turns it round and round
%! equilibrium (pendulum (-0.5, struct ("kind", "moment", "bodies", 1, "stations", 0, "value", 60)), 0);
%!function [q, lambda, system, F] = arch ()   # two rods of slope 3:4 on pins, their weight, and a force on the apex
%!  F = 50;
%!  rod = struct ("length", 1, "EA", 1e8, "EI", 2e4, "rhoA", 2);
%!  body = struct ("rod", rod, "model", struct ("modes", "auto", "rotary_inertia", false, "energy", "uniaxial"));
%!  alpha = atan2 (3, 4);
%!  scene.bodies = {setfield(body, "initial", struct ("phi", alpha)), ...
%!                  setfield(body, "initial", struct ("phi", pi - alpha, "x", 1.6, "y", 0))};
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                  struct("kind", "revolute", "bodies", 2, "stations", 0, "point", [1.6 0]), ...
%!                  struct("kind", "revolute", "bodies", [1 2], "stations", [1 1]), ...
%!                  struct("kind", "force", "bodies", 1, "stations", 1, "value", [0 -F])};
%!  scene.duration = 1;
%!  scene = check_mechanism (scene);
%!  system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, [8 8], [1 1])));
%!  [q, lambda] = equilibrium (mechanism_at_rest (scene, system.mechanism), 0);
%!endfunction
%!test # reactions and deflections of a two-rod arch: closed form of small deflections
%! [q, lambda, system, F] = arch ();
%! [mg, c, s] = deal (2*9.81, 0.8, 0.6);
%! [up, across] = deal (F/2 + mg, (F/2 + mg/2)*c/s);  # of each support
%! assert (-lambda(1:2), [across; up], 1e-4*up);
%! assert (-lambda(3:4), [-across; up], 1e-4*up);
%! N = across*c + (F/2 + mg/2)*s;  # mean thrust
%! at = markers_of_states (system.mechanism, q, 0*q);
%! drop = 0.6 - at.y(system.mechanism.marker_of(3,1));
%! assert (drop, N/(1e8*s), 1e-3*drop);
%! i = index_of (system.mechanism, 1);
%! middle = functions_at (system.mechanism.models{1}.base, 0.5);
%! [~, bent] = functions_at (system.mechanism.models{1}.base, 0.5);
%! assert (bent*q(i(1:10)), -5*mg*c/(384*2e4), 1e-3*5*mg*c/(384*2e4));
%!test # a hanging elastic line: stretched by its own weight as the strain (g - 1)/2 says
%! scene = struct ("surface", struct ("name", "plane", "inclination", pi/2), "duration", 1, ...
%!                 "ends", {{"hinge", "free"}}, "rod", struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1), ...
%!                 "model", struct ("modes", [3 6]));
%! scene.initial.angle = -pi/2;
%! scene = check_surface_scene (scene);
%! system = surface_rod (scene);
%! z = equilibrium (surface_at_rest (scene, system), 0);
%! tip = system.fields (0, z, z, z, 1).alpha2;
%! assert (-tip - 1, 9.81/1e4/2, 1e-6);
%!test # of a stiff rod on an inclined plane, which swings down to the line of its slope from across it
%! rod = struct ("length", 0.1, "EA", 2e5, "EI", 1/60, "rhoA", 7.8e-3);
%! scene = check_surface_scene (struct ("surface", struct ("name", "plane", "inclination", pi/6), "duration", 1, ...
%!                                      "ends", {{"hinge", "free"}}, "rod", rod, "model", struct ("modes", [4 4])));
%! system = surface_rod (scene);
%! z = equilibrium (surface_at_rest (scene, system), 0);
%! at = system.fields (0, z, z, z, 0.1);
%! assert ([at.alpha1, at.alpha2], [0, -0.1], 1e-7);
%!test # two masses and a spring, held by nothing: they meet in the middle, at once
%! K = [5 -5; -5 5];
%! balance = struct ("n", 2, "multipliers", 0, "start", [0; 0.04], "length", 1, "size", @(step) max (abs (step)));
%! balance.residual = @(t, q, v, lambda) -K*q;
%! balance.tangent = @(t, q, lambda) K;
%! balance.damping = @(t, q, lambda) zeros (2);
%! balance.mass = @(q) diag ([1 1]);
%! [q, ~, linear] = equilibrium (balance, 0);
%! assert (q, [0.02; 0.02], 1e-12); assert (linear.K, K);
%! balance.mass = @(q) diag ([1 1])*1e8;  # what accelerates them by 1e-14 m/s^2 is nothing
%! balance.residual = @(t, q, v, lambda) [1e-6; 1e-6] - K*q;
%! assert (equilibrium (setfield (balance, "start", [0.02; 0.02]), 0), [0.02; 0.02], 1e-12);
