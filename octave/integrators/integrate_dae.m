## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_dae (@var{code}, @var{system}, @var{times}, @var{start}, @
##   @var{solver})
## Octave's DAE codes, @var{code} = "ode15i" (IDA of SUNDIALS) or "daspk" (Brown, Hindmarsh and Petzold, 1994), on the
## stabilised index-2 formulation of @code{integrate_radau} in y = (q; v; lambda; mu; W; D), with
## @var{solver}.tolerance (m).  Multipliers are left out of the error test (daspk), or have a wide tolerance (ode15i).
## @var{steps} is not known: NaN.
## @end deftypefn

function [states, steps] = integrate_dae (code, system, times, start, solver)
  steps = NaN;
  n = system.n;
  c = system.constraint_count;
  [a, lambda, at] = constrained_accelerations (system, times(1), start.q, start.v);
  y = [start.q; start.v; lambda; zeros(c, 1); start.W; start.D];
  y_dot = [start.v; a; zeros(2*c, 1); system.work_rate(at, lambda); at.dissipated];
  residual = @(t, y, y_dot) equations (t, y, y_dot, system);
  scale = solver.tolerance/100*[system.q_scale; system.q_scale/(0.1*system.duration); 1e10*ones(2*c, 1); 1e3; 1e3];
  by = struct ("daspk", @by_daspk, "ode15i", @by_ode15i).(code);
  reached = quietly (@() by (residual, times, y, y_dot, scale, 2*n + (1:2*c)));
  lost = find ([any(! isfinite (reached), 2); true], 1);
  if (lost <= numel (times))
    stop_integration (code, system, times(max (lost - 1, 1)), NaN, "it gave up", "a larger tolerance");
  endif
  states = named_rows (system, reached(:,[1:2*n+c, end-1, end]).');
endfunction

function r = equations (t, y, y_dot, system)
  n = system.n;
  c = system.constraint_count;
  q = y(1:n);
  v = y(n+1:2*n);
  lambda = y(2*n+1:2*n+c);
  mu = y(2*n+c+1:2*n+2*c);
  at = system.at (t, q, v);
  r = [system.inertia(at, y_dot(1:n) - v) + system.reaction(at, mu)
       system.inertia(at, y_dot(n+1:2*n)) - at.force + system.reaction(at, lambda)
       at.constraints.residual
       at.constraints.velocity
       y_dot(end-1) - system.work_rate(at, lambda)
       y_dot(end) - at.dissipated];
endfunction

function reached = by_daspk (residual, times, y, y_dot, scale, algebraic)
  names = {"absolute tolerance", "relative tolerance", "algebraic variables", ...
          "exclude algebraic variables from error test", "compute consistent initial condition"};
  settings = cellfun (@(name) daspk_options (name), names, "uniformoutput", false);
  unwind_protect
    daspk_options ("relative tolerance", 0*scale);
    daspk_options ("absolute tolerance", scale);
    is_algebraic = zeros (numel (y), 1);
    is_algebraic(algebraic) = 1;
    daspk_options ("algebraic variables", is_algebraic);
    daspk_options ("exclude algebraic variables from error test", 1);
    reached = told_errors (@(f) daspk (f, y, y_dot, times), @(y, y_dot, t) residual (t, y, y_dot));
  unwind_protect_cleanup
    cellfun (@(name, value) daspk_options (name, value), names, settings);
  end_unwind_protect
endfunction

function reached = by_ode15i (residual, times, y, y_dot, scale, algebraic)
  requested = unique ([times, mean(times)]);
  options = odeset ("RelTol", 1e-13, "AbsTol", scale);
  try
    [~, reached] = told_errors (@(f) ode15i (@(t, u, u_dot) f (t, u, u_dot), requested, y, y_dot, options), ...
                                residual);
    reached = reached(ismember (requested, times)(1:rows (reached)),:);
  catch err
    if (isempty (strfind (err.message, "IDA")))
      rethrow (err);
    endif
    reached = y.';
  end_try_catch
endfunction

%!assert (swing_pendulum ("daspk", [0 0.3 0.8])(2:3), pendulum_angle ([0.3 0.8]), 1e-6)
%!testif HAVE_SUNDIALS
%! assert (swing_pendulum ("ode15i", [0 0.3 0.8])(2:3), pendulum_angle ([0.3 0.8]), 1e-6);
%!function t = until_lost (t)
%!  if (t > 0.1)
%!    error ("the load is lost");
%!  endif
%!endfunction
%!function run_with_lost_load (name)   # from t = 0.1 s on
%!  [system, start] = sample_pendulum ();
%!  at = system.at;
%!  system.at = @(t, q, v) at (until_lost (t), q, v);
%!  integrate_dae (name, system, [0 0.5 1], start, struct ("tolerance", 1e-8));
%!endfunction
%!error <the load is lost> run_with_lost_load ("daspk")
%!testif HAVE_SUNDIALS
%! fail ("run_with_lost_load ('ode15i')", "the load is lost");
