## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{lambda}] =} static_equilibrium (@var{system}, @var{q})
## Coordinates near @var{q} (n-by-1) at which a mechanism (see @code{mechanism_system}) rests under its loads at t = 0,
## and its multipliers, by Newton's iteration.  Where it does not converge, it is an error.
## @end deftypefn

function [q, lambda] = static_equilibrium (system, q)
  n = system.n;
  q = project_positions (system, 0, q);
  lambda = zeros (system.constraint_count, 1);
  z = [q; lambda];
  for iteration = 1:50
    r = residual (system, z);
    J = zeros (numel (z));
    for k = 1:numel (z)
      h = 1e-6*max (1, abs (z(k)));
      e = zeros (size (z));
      e(k) = h;
      J(:,k) = (residual (system, z + e) - residual (system, z - e))/(2*h);
    endfor
    step = -J \ r;
    z += step*min (1, 0.3/max (abs (step(1:n))./system.q_scale));
    if (max (abs (step(1:n))) < 1e-12)
      q = z(1:n);
      lambda = z(n+1:end);
      return;
    endif
  endfor
  scene_error (["no equilibrium was found from the bodies' places: the last step was %.2g m; place them nearer" ...
                " to it"], max (abs (step(1:n))));
endfunction

function r = residual (system, z)
  q = z(1:system.n);
  lambda = z(system.n+1:end);
  at = system.at (0, q, 0*q);
  r = [at.force - system.reaction(at, lambda); at.constraints.residual];
endfunction

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
%!  [q, lambda] = static_equilibrium (system, placed_bodies (scene, system.mechanism));
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
