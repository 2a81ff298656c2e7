## -*- texinfo -*-
## @deftypefn {} {@var{turning} =} steady_mechanism (@var{scene})
## The bodies of a checked @var{scene} in steady rotation about the point that holds them (see @code{rotation_centre}),
## all as one, without weight and loads, as @code{campbell} takes them: a struct of speed (rad/s, the largest that a
## joint "angle" of the ground prescribes, NaN without one), about (speed, q), as @code{about_rotation}, and where a
## body does not state its modes richer, the same of twice as many base functions.  Such bodies have 8 of each sort
## together, geometrically exact ones 16, at least 3 each.
## @end deftypefn

function turning = steady_mechanism (scene)
  centre = rotation_centre (scene);
  turning.speed = NaN;
  for k = 1:numel (scene.joints)
    if (strcmp (scene.joints(k).kind, "angle") && any (scene.joints(k).bodies == 0))
      turning.speed = max (turning.speed, fastest_rotation (scene.joints(k).value, scene.duration));
    elseif (is_load (scene.joints(k)))
      scene.joints(k).value = @(t) 0*scene.joints(k).value (t);
    endif
  endfor
  scene.gravity = 0;
  exact = any (arrayfun (@(body) strcmp (body.model.stiffening, "exact"), scene.bodies));
  functions = 8*(1 + exact);  # polynomials have the sixth mode less well than sines
  auto = sum (arrayfun (@(body) ischar (body.model.modes), scene.bodies));
  each = max (3, floor (functions/max (auto, 1)));
  mechanism = model_of (mechanism_kind (), scene, each);
  softening_note (mechanism.models);
  turning.about = about_of (scene, mechanism, centre);
  if (auto > 0)
    turning.richer = @(speed, q) about_of (scene, model_of (mechanism_kind (), scene, 2*each), centre)(speed, q);
  endif
endfunction

function linear_at = about_of (scene, mechanism, centre)
  balance = mechanism_at_rest (scene, mechanism);
  linear_at = @(speed, q) about (rotating_balance (balance, speed, centre), speed, q);
endfunction

function [linear, q] = about (balance, speed, q)
  if (isempty (q))
    q = balance.start;
  endif
  [q, ~, linear] = equilibrium (balance, 0, q);
  refuse_negative_mass (linear, sprintf ("at %g rad/s", speed));
endfunction

%!function scene = spinner (joints, count, varargin)   # equal rods of unit length, mass and EI in all, the first on top
%!  rod = struct ("length", 1/count, "EA", 1e8, "EI", 1, "rhoA", 1, "rhoI", 0, "half_height", 0.001);
%!  body = struct ("rod", rod, "model", struct ("modes", "auto", "energy", "uniaxial"), varargin{:});
%!  scene.bodies = repmat ({body}, 1, count);
%!  weld = @(k) struct ("kind", "weld", "bodies", [k k+1], "stations", [1/count 0]);
%!  scene.joints = [{struct("kind", "revolute", "bodies", 1, "stations", 0)}, joints, arrayfun(weld, 1:count-1, ...
%!                  "uniformoutput", false)];
%!  scene.duration = 1;
%!  scene = check_mechanism (scene);
%!endfunction
%!function omega = slowest (scene, speed, n)
%!  omega = sort (vibrations (steady_mechanism (scene).about (speed, [])).omega)(1:n);
%!endfunction
%!test # one rod in a hub, and two that are welded: the power series of the beam that turns
%! hub = {struct("kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [6*t, 6, 0])};
%! assert (steady_mechanism (spinner (hub, 1)).speed, 6);
%! push = struct ("kind", "force", "bodies", 1, "stations", 1, "value", [0 0]);  # loads are left out
%! assert (slowest (spinner ([hub, {push}], 1), 8, 2), slowest (spinner (hub, 1), 8, 2), -1e-7);
%! for count = 1:2
%!   for speed = [0 8]
%!     assert (slowest (spinner (hub, count), speed, 2), turning_beam (speed, 2, "clamped"), -2e-5);
%!   endfor
%! endfor
%!test # a geometrically exact one, also its sixth mode
%! hub = {struct("kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [6*t, 6, 0])};
%! scene = exact_bodies (spinner (hub, 1));
%! assert (slowest (scene, 0, 6), turning_beam (0, 6, "clamped"), -1e-3);
%!test # what turns one body against the other is no speed about the point that holds them
%! between = {struct("kind", "angle", "bodies", [1 2], "stations", [0.5 0], "value", @(t) [6*t, 6, 0])};
%! assert (steady_mechanism (spinner (between, 2)).speed, NaN);
%!test # free at its hinge, in two: it turns, and bends
%! assert (slowest (spinner ({}, 2), 6, 3), [0, rotating_beam(6, 2).'], 1e-2);
%!test # a rod pinned to the rim of a rigid hub swings at spin*sqrt (3/2 radius/length)
%! hub = struct ("rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 1), "model", struct ("modes", [0 0]));
%! rod = setfield (hub, "rod", "length", 1);
%! scene.bodies = {hub, rod};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), struct("kind", "angle", "bodies", 1), ...
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [2 0])};
%! scene.joints{2}.stations = 0;
%! scene.duration = 1;
%! assert (slowest (check_mechanism (scene), 5, 1), 5*sqrt (3/2*2/1), -1e-5);
%!test # what its rigid bodies leave is a rod's; all that is stated is not made richer
%! hub = {struct("kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [6*t, 6, 0])};
%! scene = spinner (hub, 2);
%! scene.bodies(1).model.modes = [0 0];
%! turning = steady_mechanism (scene);  # of 8 of both sorts, and a correction
%! assert ([rows(turning.about (0, []).M), rows(turning.richer (0, []).M)], 1 + [16 32]);
%! scene.bodies(2).model = setfield (scene.bodies(2).model, "modes", [1 2]);
%! assert (isfield (steady_mechanism (scene), "richer"), false);
