## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} index3_alpha (@var{ode}, @var{h}, @var{solver})
## The generalized-alpha method on the index-3 equations M q'' + Phi_q' lambda = f, Phi = 0 (Arnold and Bruels,
## Multibody Syst. Dyn. 18, 2007) in steps of @var{h} (s), for @code{integrate_fixed}: Newton's unknowns are the step's
## change of q and h^2 lambda, so that its matrix does not grow worse as h goes to 0 (Bottasso, Bauchau and Cardona,
## SIAM J. Sci. Comput. 29, 2007).  Springs' tensions are unknowns, too, as in @code{radau_step}.  Velocities meet
## their constraints only up to the error.
## @end deftypefn

function stepper = index3_alpha (ode, h, solver)
  c = alpha_coefficients (solver.rho_infinity);
  system = ode.constrained;
  n = system.n;
  stepper.form = @(y) [y; NaN(2*n + system.constraint_count, 1)];
  stepper.state = @(z) z(1:2*n+2);
  stepper.step = @(t, z) step (t, z, c, h, system);
endfunction

## z: q, v, W, D; then the auxiliary accelerations a, the accelerations and lambda, not known at first
function [z, converged] = step (t, z, c, h, system)
  n = system.n;
  [q, v, W, D] = deal (z(1:n), z(n+1:2*n), z(2*n+1), z(2*n+2));
  [a, v_dot, lambda] = deal (z(2*n+3:3*n+2), z(3*n+3:4*n+2), z(4*n+3:end));
  if (isnan (a(1)))
    [v_dot, lambda] = constrained_accelerations (system, t, q, v);
    a = v_dot;
  endif
  before = system.at (t, q, v);
  power = @(at, lambda) [system.work_rate(at, lambda); at.dissipated];
  start = power (before, lambda);
  [next, sigma] = deal (v_dot, before.springs.tension);
  [last, factor] = deal (Inf, h^2*c.beta*c.part);
  for sweep = 1:30
    [new_q, new_v] = alpha_update (c, h, q, v, a, v_dot, next);
    at = system.at (t + h, new_q, new_v);
    if (sweep == 1)
      [mass, jacobian, spring_jacobian] = system.matrices (at);
      tangent = mass + factor*system.tangent (at, lambda, sigma) + h*c.gamma*c.part*system.damping_matrix;
      stiffness = max (at.springs.stiffness + c.gamma/(c.beta*h)*at.springs.damping, eps);
    endif
    excess = sigma - at.springs.tension;
    force = at.force - system.reaction (at, lambda) - system.spring_reaction (at, excess);
    residual = factor*(system.inertia (at, next) - force);
    [dq, pull] = saddle_solve (system, t, tangent, [jacobian; spring_jacobian], -residual, ...
                               [-at.constraints.residual; excess./stiffness], [0*lambda; 1./(factor*stiffness)]);
    next += dq/factor;
    lambda += pull(1:numel (lambda))/factor;
    sigma += pull(numel (lambda)+1:end)(:)/factor;  # a column also of none
    change = max (abs (dq)./system.q_scale);
    converged = change < 1e-12 || (change < 1e-10 && change >= last);
    if (converged || (sweep > 3 && ! (change < 1)))
      break;
    endif
    last = change;
  endfor
  [q, v, a] = alpha_update (c, h, q, v, a, v_dot, next);
  work = h/2*(start + power (at, lambda));
  z = [q; v; W + work(1); D + work(2); a; next; lambda];
endfunction

%!test # positions meet their constraints at any step
%! [~, states] = swing_pendulum ("generalized_alpha", [0 0.5], "step", 0.05);
%! assert (states.q(2:3,2), [0; 0], 1e-10);
