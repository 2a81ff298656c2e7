## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_radau (@var{system}, @var{times}, @var{start}, @var{solver})
## Radau IIA of order 9 (Hairer and Wanner, Solving Ordinary Differential Equations II, IV.8 and VII) on the stabilised
## index-2 formulation of Gear, Gupta and Leimkuhler (J. Comput. Appl. Math. 12, 1985), M (q' - v) + Phi_q' mu = 0,
## M v' + Phi_q' lambda = f, Phi = 0, Phi' = 0: positions and velocities meet their constraints at every
## frame: at all @var{times}, or where @var{system}.frames (1-by-k, s) has some of them, at these.
##
## Windows of many steps, or panels, are solved at once (see @code{radau_window}): as many as @code{radau_plan} says.
## The panels' length follows from the embedded formula of order 5, in @var{solver}.tolerance (m); a panel that is too
## long ends its window. @var{start} and @var{states} have q, v, W, D; states also lambda, a column a time of
## @var{times} (1-by-m, s).
## @end deftypefn

function [states, steps] = integrate_radau (system, times, start, solver)
  persistent rule = radau_rule (5);
  y = setfield (start, "t", times(1));
  [y.a, y.lambda, at] = constrained_accelerations (system, y.t, y.q, y.v);
  y.sigma = at.springs.tension;
  states = repmat (stacked_rows (y), 1, numel (times));
  plan = struct ("h", 1e-3*system.duration, "reach", Inf, "whole", 0, "patience", 4);
  plan.most = max (1, min (160, floor (14e3/system.n^2)));
  plan.panels = min (4, plan.most);
  guess = alone = @(t) taylor (y, t - y.t);
  if (isfield (system, "led"))
    guess = @(t) system.led (t, y);
    plan.h = system.led_step (solver.tolerance);
    plan.panels = plan.most;
  endif
  steps = refused = 0;
  while (y.t < times(end))
    to_go = max (1, ceil ((times(end) - y.t)/plan.h*(1 - 1e-9)));
    count = min (to_go, plan.panels);
    if (count == to_go)
      plan.h = (times(end) - y.t)/count;
    endif
    h = plan.h;
    [window, why] = radau_window (system, rule, y, h, count, guess, solver.tolerance, plan.whole > 0);
    kept = find ([window.error_ratio > 1, true], 1) - 1;
    steps += max (kept, 1);
    if (kept > 0)
      before = y;
      y = after (rule, window, y, h, kept);
      refuse_steep (system, solver, y.t, y.q);
      if (kept == to_go)
        y.t = times(end);
      endif
      inside = times > before.t & times <= y.t;
      if (any (inside))
        states(:,inside) = stacked_rows (radau_frames (rule, window, before, h, times(inside)));
      endif
      guess = alone = @(t) radau_guess (system, rule, window, y, h, kept, t);
      if (isfield (system, "led") && plan.panels > 1)
        guess = @(t) system.led (t, y);
      endif
      refused = 0;
    else
      if (! window.converged)
        guess = alone;
      endif
      refused++;
    endif
    plan = radau_plan (plan, window, count, kept);
    if (plan.h < 1e-10*system.duration || refused > 30)
      [~, jacobian] = system.matrices (system.at (y.t, y.q, y.v));
      refuse_dependent (system, y.t, jacobian, 1e-4);
      refuse_steep (system, struct ("steepest", 1), y.t, y.q);
      stop_integration ("radau", system, y.t, plan.h, why, ...
                        "a larger tolerance, or a look at the mechanism there");
    endif
  endwhile
  states = named_rows (system, states);
  met = are_frames (system, times);
  [states.q(:,met), states.v(:,met)] = onto_constraints (system, times(met), states.q(:,met), states.v(:,met));
endfunction

function y = after (rule, window, y, h, kept)
  s = numel (rule.c);
  weights = rule.A(s,:).';
  y.t += kept*h;
  for name = {"q", "v", "a", "lambda", "sigma"}
    y.(name{1}) = window.(name{1}){s}(:,kept);
  endfor
  y.W += h*sum (window.power(1:kept,:)*weights);
  y.D += h*sum (window.dissipated(1:kept,:)*weights);
endfunction

function [q, v] = taylor (y, dt)
  q = y.q + y.v*dt + y.a*(dt.^2/2);
  v = y.v + y.a*dt;
endfunction

%!test # the elliptic function of the pendulum, at two tolerances
%! for tolerance = [1e-6 1e-10]
%!   phi = swing_pendulum ("radau", [0 0.3 0.8], "tolerance", tolerance);
%!   assert (phi(2:3), pendulum_angle ([0.3 0.8]), 2*tolerance);
%! endfor
%!test # the work of a force is what the energies gain, however short the steps
%! rod = struct ("length", 0.4, "EA", 1e6, "EI", 1e4, "rhoA", 1.5);
%! body = struct ("rod", rod, "model", struct ("modes", [0 0]));
%! scene.bodies = {body, body};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [0.4 0]), ...
%!                 struct("kind", "force", "bodies", 2, "stations", 0.4, "value", @(t) 20*sin (600*t)*[0.3, 1])};
%! [scene.duration, scene.gravity, scene.frames_per_second] = deal (0.002, 0, 2e4);
%! scene = check_mechanism (scene);
%! model = build_mechanism (scene, mechanism_rungs (scene, [0 0]));
%! for tolerance = [1e-5 1e-9]
%!   run = run_model (mechanism_kind (), scene, model, struct ("name", "radau", "tolerance", tolerance));
%!   assert (run.history.T(end), run.history.W(end), 1e-8*run.history.W(end));
%! endfor
%!function system = arm (from, rate)   # two rods of 1 m from the origin to a place that moves along x
%!  rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1);
%!  phi = acos (from/2)*[1 -1];
%!  for k = 1:2
%!    scene.bodies{k} = struct ("rod", rod, "model", struct ("modes", [0 0]), "initial", struct ("phi", phi(k)));
%!  endfor
%!  value = @(t) [from + rate*t, 0; rate, 0; 0, 0];
%!  scene.joints = {struct("name", "shoulder", "kind", "revolute", "bodies", 1, "stations", 0)
%!                  struct("name", "elbow", "kind", "revolute", "bodies", [1 2], "stations", [1 0])
%!                  struct("name", "hand", "kind", "position", "bodies", 2, "stations", 1, "value", value)};
%!  scene.duration = 1;
%!  scene = check_mechanism (scene);
%!  system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, [0 0])));
%!endfunction
%!error <stopped at t = 0.5[0-9]* s of 1 s: it came to a singular position: 1 of 6 constraints .* (shoulder|elbow|hand): >
%! system = arm (1.75, 0.5);  # stretched at t = 0.5 s, and pulled on
%! q = [acos(0.875); 0; 0; -acos(0.875); 0.875; sin(acos (0.875))];
%! start = struct ("q", q, "v", project_velocities (system, 0, q, 0*q), "W", 0, "D", 0);
%! integrate_radau (system, [0 1], start, struct ("tolerance", 1e-6));
%!error <radau stopped at t = 0.[0-9]* s of 1 s: its loads or states are no numbers>
%! [system, start] = sample_pendulum ();
%! system.mechanism.loads = struct ("value", @(t) 1./(t < 0.4) - 1./(t < 0.4), "parts", 3, "first", 1, "second", 2);
%! scene = struct ("duration", 1, "breaks", []);
%! integrate_radau (mechanism_system (scene, system.mechanism), [0 1], start, struct ("tolerance", 1e-6));
%!error <asked for its step> # a run that leads says it
%! [system, start] = sample_pendulum ();
%! system.mechanism.loads = [];
%! system = mechanism_system (struct ("duration", 1, "breaks", []), system.mechanism);
%! [system.led, system.led_step] = deal (@(t, y) 0, @(tolerance) error ("asked for its step"));
%! integrate_radau (system, [0 1], start, struct ("tolerance", 1e-6));
