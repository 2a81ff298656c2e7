## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_radau (@var{system}, @var{times}, @var{start}, @var{solver})
## Radau IIA of order 9 (Hairer and Wanner, Solving Ordinary Differential Equations II, IV.8 and VII) on the stabilised
## index-2 formulation of Gear, Gupta and Leimkuhler (J. Comput. Appl. Math. 12, 1985), M (q' - v) + Phi_q' mu = 0,
## M v' + Phi_q' lambda = f, Phi = 0, Phi' = 0: positions and velocities meet their constraints at every step.
## Steps follow from the embedded formula of order 5, in @var{solver}.tolerance (m).
## @var{start} and @var{states} have q, v, W, D; states also lambda, a column a time of @var{times} (1-by-m, s).
## @end deftypefn

function [states, steps] = integrate_radau (system, times, start, solver)
  persistent rule = radau_rule (5);
  states = first_states (system, times, start);
  y = start;
  [y.a, y.lambda, at] = constrained_accelerations (system, times(1), y.q, y.v);
  y.sigma = at.springs.tension;
  states.lambda(:,1) = y.lambda;
  t = times(1);
  h = min (diff (times)(1)/4, 1e-3*system.duration);
  steps = 0;
  last = [];
  refused = 0;
  for k = 2:numel (times)
    while (t < times(k))
      to_go = times(k) - t;
      pieces = ceil (to_go/h*(1 - 1e-9));
      step = to_go/pieces;
      [next, error_ratio, stages, why] = radau_step (system, rule, t, y, step, last, solver.tolerance, refused > 1);
      steps++;
      if (error_ratio <= 1)
        t += step;
        if (pieces == 1)
          t = times(k);
        endif
        y = next;
        last = stages;
        h = step*min (4, max (0.3, 0.85*max (error_ratio, 1e-12)^(-1/6)));
        refused = 0;
      else
        h = step*min (0.7, max (0.1, 0.85*error_ratio^(-1/6)));
        refused++;
      endif
      if (h < 1e-10*system.duration || refused > 30)
        [~, jacobian] = system.matrices (system.at (t, y.q, y.v));
        refuse_dependent (system, t, jacobian, 1e-4);
        stop_integration ("radau", system, t, system.duration, h, why, ...
                          "a larger tolerance, or a look at the mechanism there");
      endif
    endwhile
    states = keep (states, k, y);
  endfor
endfunction

## @var{s} stages, odd: collocation at the zeros of d^(s-1)/dx^(s-1) (x^(s-1) (x - 1)^s); error formula
## of Hairer and Wanner
function rule = radau_rule (s)
  p = 1;
  for k = 1:2*s-1
    p = conv (p, [1, -(k > s - 1)]);
  endfor
  for k = 1:s-1
    p = polyder (p);
  endfor
  rule.c = sort (real (roots (p))).';
  rule.c(s) = 1;
  powers = rule.c.'.^(0:s-1);
  rule.A = (rule.c.'.^(1:s)./(1:s))/powers;
  [rule.T, eigenvalues] = eig (inv (rule.A));
  eigenvalues = diag (eigenvalues);
  [~, order] = sort (1e3*abs (imag (eigenvalues)) - imag (eigenvalues));  # real, then the pairs, from above the axis
  rule.T = rule.T(:,order);
  rule.eigenvalues = eigenvalues(order);
  first = zeros (1, s);
  first(1) = 1;
  rule.e = -(first/powers)*inv (rule.A);
endfunction

%!test # the elliptic function of the pendulum, at two tolerances
%! for tolerance = [1e-6 1e-10]
%!   phi = swing_pendulum ("radau", [0 0.3 0.8], "tolerance", tolerance);
%!   assert (phi(2:3), pendulum_angle ([0.3 0.8]), 2*tolerance);
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
%! system.mechanism.loads = struct ("value", @(t) 1/(t < 0.4) - 1/(t < 0.4), "parts", 3, "first", 1, "second", 2);
%! scene = struct ("duration", 1, "breaks", []);
%! integrate_radau (mechanism_system (scene, system.mechanism), [0 1], start, struct ("tolerance", 1e-6));
