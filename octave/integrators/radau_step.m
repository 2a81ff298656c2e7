## -*- texinfo -*-
## @deftypefn {} {[@var{next}, @var{error_ratio}, @var{stages}, @var{why}] =} radau_step (@var{system}, @var{rule}, @
##   @var{t}, @var{y}, @var{h}, @var{last}, @var{tolerance}, @var{whole})
## One step of @code{integrate_radau} from the state @var{y} (q, v, a, lambda, sigma, W, D) at @var{t} to t + @var{h}
## (s).  The @var{stages} of the @var{last} step give the first guess.  @var{error_ratio} > 1: refused, and @var{why}.
##
## The springs' tensions sigma are unknowns of Newton's iteration, as multipliers are: for stiff springs it converges
## then as for the joints that they tend to; otherwise k would multiply what their directions turn within the step.
##
## Newton's matrix is that of the middle stage, or, where @var{whole} is true, of every stage where it is: beyond a
## singular position the constraints' gradients point the other way, and with one matrix it would not pass.
## @end deftypefn

function [next, error_ratio, stages, why] = radau_step (system, rule, t, y, h, last, tolerance, whole = false)
  [n, c] = deal (system.n, system.constraint_count);
  scale = tolerance*system.q_scale;
  [q, v, lambda, sigma] = first_guess (rule, y, h, last);
  s = numel (rule.c);
  mu = zeros (c, s);
  middle = system.at (t + h*rule.c((s+1)/2), q(:,(s+1)/2), v(:,(s+1)/2));
  [mass, jacobian, spring_jacobian] = system.matrices (middle);
  tangent = system.tangent (middle, lambda(:,(s+1)/2), sigma(:,(s+1)/2));
  factors = radau_factors (rule, h, mass, tangent, system.damping_matrix, jacobian, spring_jacobian, middle.springs);
  inverse = inv (rule.A).'/h;
  [next, stages, error_ratio, change] = deal (y, [], 10, Inf);
  why = "its Newton iteration did not converge";
  for iteration = 1:15
    at = system.at (t + h*rule.c, q, v);
    u = (q - y.q)*inverse;
    a = (v - y.v)*inverse;
    excess = sigma - at.springs.tension;
    residual = [system.inertia(at, u - v) + system.reaction(at, mu)
                system.inertia(at, a) - at.force + system.reaction(at, lambda) + system.spring_reaction(at, excess)
                at.constraints.residual*factors.unit/h
                at.constraints.velocity*factors.unit
                factors.compliance.*excess];
    if (! all (isfinite (residual(:))))
      why = "its loads or states are no numbers";
      return;
    endif
    if (whole)
      step = solve_whole (system, rule, factors, t, q, v, mass, tangent, -residual);
    else
      step = solve_stages (rule, factors, -residual);
    endif
    q += step(1:n,:);
    v += step(n+1:2*n,:);
    lambda += step(2*n+1:2*n+c,:)*factors.unit;
    mu += step(2*n+c+1:2*n+2*c,:)*factors.unit;
    sigma += step(2*n+2*c+1:end,:)*factors.unit;
    [before, change] = deal (change, max (max (abs ([step(1:n,:); h*step(n+1:2*n,:)])./[scale; scale])));
    met = all (abs (at.constraints.residual)(:) <= 1e-11) && all (abs (at.constraints.velocity)(:) <= 1e-9);
    settled = change <= 0.05 && change > before/2 && met;  # as near as rounding lets it, at a singular position
    if (change < 1e-7 || (change <= 1e-3 && met) || (whole && settled))
      why = "its steps shrank to nothing";
      break;
    elseif (! (change < 1e8) || (iteration > 3 && change > 0.9*before && change > 1e-6))
      return;
    endif
  endfor
  if (iteration == 15)
    return;
  endif
  a = (v - y.v)*inverse;
  stages = struct ("q", q, "v", v, "lambda", lambda, "sigma", sigma, "h", h, "q_start", y.q, "v_start", y.v);
  error_ratio = embedded_error (rule, factors, mass, y, q - y.q, v - y.v, h, scale);
  weights = rule.A(s,:).';
  power = at.power + sum (lambda.*at.constraints.rate, 1);
  next = struct ("q", q(:,s), "v", v(:,s), "a", a(:,s), "lambda", lambda(:,s), "sigma", sigma(:,s), ...
                 "W", y.W + h*power*weights, "D", y.D + h*at.dissipated*weights);
endfunction

## the last step's polynomials, or Taylor's
function [q, v, lambda, sigma] = first_guess (rule, y, h, last)
  if (isempty (last))
    q = y.q + y.v*(h*rule.c) + y.a*((h*rule.c).^2/2);
    v = y.v + y.a*(h*rule.c);
    lambda = repmat (y.lambda, 1, numel (rule.c));
    sigma = repmat (y.sigma, 1, numel (rule.c));
    return;
  endif
  at = 1 + h/last.h*rule.c.';
  nodes = [0; rule.c.'];
  s = numel (rule.c);
  basis = (at.^(0:s))/(nodes.^(0:s));
  q = [last.q_start, last.q]*basis.';
  v = [last.v_start, last.v]*basis.';
  of_stages = ((at.^(0:s-1))/(rule.c.'.^(0:s-1))).';
  lambda = last.lambda*of_stages;
  sigma = last.sigma*of_stages;
endfunction

function step = solve_stages (rule, factors, right)
  right = right*inv (rule.T).';
  w = zeros (size (right));
  for i = 1:numel (factors.L)
    k = 2*i - 2 + (i == 1);
    w(:,k) = factors.Q{i}*(factors.U{i} \ (factors.L{i} \ (factors.P{i}*right(:,k))));
    w(:,2*i-1) = [conj(w(:,k)), w(:,k)](:,1 + (i == 1));
  endfor
  step = real (w*rule.T.');
endfunction

function step = solve_whole (system, rule, factors, t, q, v, mass, tangent, right)
  matrix = kron (inv (rule.A)/factors.h, factors.rates);
  width = rows (right);
  for i = 1:numel (rule.c)
    [~, jacobian, spring_jacobian] = system.matrices (system.at (t + factors.h*rule.c(i), q(:,i), v(:,i)));
    own = (i - 1)*width + (1:width);
    matrix(own,own) += radau_matrix (0, factors.h, mass, tangent, system.damping_matrix, jacobian, spring_jacobian, ...
                                     factors.springs);
  endfor
  warning_state = warning ("off", "all");
  step = reshape (matrix \ right(:), width, []);
  warning (warning_state);
endfunction

## filtered by the real factors, so that stiff modes count as what they will be
function ratio = embedded_error (rule, factors, mass, y, Z_q, Z_v, h, scale)
  n = rows (mass);
  g = real (rule.eigenvalues(1));
  right = [mass*(y.v + Z_q*rule.e.'/h); mass*(y.a + Z_v*rule.e.'/h)];
  right(end+1:rows (factors.P{1})) = 0;
  found = real (factors.Q{1}*(factors.U{1} \ (factors.L{1} \ (factors.P{1}*right))));
  ratio = max (max (abs ([found(1:n); h*found(n+1:2*n)])./[scale; scale]));
endfunction

%!test # one step leaves positions and velocities on their constraints
%! [system, start] = sample_mechanism ([0 1]);
%! states = integrate_radau (system, [0 0.01], start, struct ("tolerance", 1e-4));
%! at = system.at (0.01, states.q(:,2), states.v(:,2));
%! assert (abs (at.constraints.residual) < 1e-10);
%! assert (abs (at.constraints.velocity) < 1e-8);
