## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_radau (@var{system}, @var{times}, @var{start}, @var{solver})
## Radau IIA of order 5 (Hairer and Wanner, Solving Ordinary Differential Equations II, IV.8 and VII) on the stabilised
## index-2 formulation of Gear, Gupta and Leimkuhler (J. Comput. Appl. Math. 12, 1985), M (q' - v) + Phi_q' mu = 0,
## M v' + Phi_q' lambda = f, Phi = 0, Phi' = 0: positions and velocities meet their constraints at every step.
## Steps follow from the embedded formula of order 3, in @var{solver}.tolerance (m).
## @var{start} and @var{states} have q, v, W, D; states also lambda, a column a time of @var{times} (1-by-m, s).
## @end deftypefn

function [states, steps] = integrate_radau (system, times, start, solver)
  persistent rule = radau_rule ();
  states = first_states (system, times, start);
  y = start;
  [y.a, y.lambda] = constrained_accelerations (system, times(1), y.q, y.v);
  states.lambda(:,1) = y.lambda;
  [t, h, steps, last, refused] = deal (times(1), min (diff (times)(1)/4, 1e-3*system.duration), 0, [], 0);
  for k = 2:numel (times)
    while (t < times(k))
      to_go = times(k) - t;
      pieces = ceil (to_go/h*(1 - 1e-9));
      step = to_go/pieces;
      [next, error_ratio, stages, why] = radau_step (system, rule, t, y, step, last, solver.tolerance);
      steps++;
      if (error_ratio <= 1)
        t = [t + step, times(k)](1 + (pieces == 1));
        [y, last] = deal (next, stages);
        h = step*min (4, max (0.3, 0.85*max (error_ratio, 1e-12)^(-1/4)));
        refused = 0;
      else
        h = step*min (0.7, max (0.1, 0.85*error_ratio^(-1/4)));
        refused++;
      endif
      if (h < 1e-10*system.duration || refused > 30)
        stop_integration ("radau", system, t, system.duration, h, why, "a larger tolerance, or a look at the mechanism there");
      endif
    endwhile
    states = keep (states, k, y);
  endfor
endfunction

function rule = radau_rule ()
  s = sqrt (6);
  rule.c = [(4 - s)/10, (4 + s)/10, 1];
  rule.A = (rule.c.'.^(1:3)./(1:3))/(rule.c.'.^(0:2));  # collocation
  [rule.T, eigenvalues] = eig (inv (rule.A));
  eigenvalues = diag (eigenvalues);
  [~, order] = sort (abs (imag (eigenvalues)) - 1e-3*imag (eigenvalues));  # real, then the one above the axis
  rule.T = rule.T(:,order);
  rule.eigenvalues = eigenvalues(order);
  rule.e = [-13 - 7*s, -13 + 7*s, -1]/3;
endfunction
