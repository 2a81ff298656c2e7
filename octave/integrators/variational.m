## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} variational (@var{ode}, @var{h}, @var{solver})
## The variational integrator of the midpoint rule with constraints (Marsden and West, Acta Numerica 10, 2001; as
## RATTLE does, positions and momenta meet their constraints after every step) in steps of @var{h} (s), for
## @code{integrate_fixed}.  It is symplectic: energy has no trend.  Damping and loads act as forces at the midpoint;
## springs' tensions there are unknowns, as in @code{radau_step}.
## @end deftypefn

function stepper = variational (ode, h, solver)
  system = ode.constrained;
  n = system.n;
  stepper.form = @(y) [y; NaN(n, 1)];
  stepper.state = @(z) z(1:2*n+2);
  stepper.step = @(t, z) step (t, z, h, system);
endfunction

## z: q, v, W, D; then the momenta, not known at first
function [z, converged] = step (t, z, h, system)
  n = system.n;
  [q, v, p] = deal (z(1:n), z(n+1:2*n), z(2*n+3:end));
  at = system.at (t, q, v);
  [mass, jacobian] = system.matrices (at);
  if (isnan (p(1)))
    p = mass*v;
  endif
  [next, lambda, last] = deal (q + h*v, zeros (system.constraint_count, 1), Inf);
  pushed = @(lambda) system.reaction (at, lambda);
  sigma = at.springs.tension;
  for sweep = 1:30
    u = (next - q)/h;
    middle = system.at (t + h/2, (q + next)/2, u);
    there = system.at (t + h, next, u);
    momentum = system.inertia (middle, u);
    excess = sigma - middle.springs.tension;
    half_force = h/2*(middle.force + system.convection (middle, u) - system.spring_reaction (middle, excess));
    residual = momentum - half_force - p + pushed (lambda);
    if (sweep == 1)
      [~, jacobian, spring_jacobian] = system.matrices (middle);
      tangent = mass + h^2/4*system.tangent (middle, lambda, sigma) + h/2*system.damping_matrix;
      stiffness = max (middle.springs.stiffness/2 + middle.springs.damping/h, eps);
    endif
    [dq, pull] = saddle_solve (system, t, tangent, [jacobian; spring_jacobian], -h*residual, ...
                               [-there.constraints.residual; excess./stiffness], [0*lambda; 2/h^2./stiffness]);
    next += dq;
    lambda += pull(1:numel (lambda))/h;
    sigma += pull(numel (lambda)+1:end)(:)*2/h^2;  # a column also of none
    change = max (abs (dq)./system.q_scale);
    converged = change < 1e-13 || (change < 1e-10 && change >= last);
    if (converged || (sweep > 3 && ! (change < 1)))
      break;
    endif
    last = change;
  endfor
  p = momentum + half_force;
  there = system.at (t + h, next, u);
  [mass, jacobian] = system.matrices (there);
  ## M v = p - Phi_q' mu, Phi_q v + Phi_t = 0
  [v, mu] = saddle_solve (system, t + h, mass, jacobian, p, -there.constraints.rate);
  p -= full (jacobian.'*mu);  # with one mu it would be sparse
  power = system.work_rate (middle, (lambda + mu)/h);
  z = [next; v; z(2*n+1:2*n+2) + h*[power; middle.dissipated]; p];
endfunction

%!test # no trend of the energy over ten swings of coarse steps
%! [~, states] = swing_pendulum ("variational", 0:0.04:12, "step", 0.04);
%! system = sample_pendulum ();
%! E = sum (mechanism_energies (system.mechanism, states.q, states.v), 1);
%! half = floor (numel (E)/2);
%! assert (abs (mean (E(1:half)) - mean (E(half+1:end))) < 0.1*(max (E) - min (E)));
