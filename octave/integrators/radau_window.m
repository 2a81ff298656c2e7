## -*- texinfo -*-
## @deftypefn {} {[@var{window}, @var{why}] =} radau_window (@var{system}, @var{rule}, @var{y}, @var{h}, @var{panels}, @
##   @var{guess}, @var{tolerance}, @var{whole})
## So many @var{panels} of @var{h} (s) of @code{integrate_radau} from the state @var{y} (t, q, v, a, lambda, sigma) on:
## the equations of all stages of all panels are evaluated at once, and Newton's iteration goes through all of them,
## from [q, v] = @var{guess} (times) on.
##
## @var{window}: converged (otherwise it says @var{why}), iterations, error_ratio (1-by-panels, above 1: too long), and
## of the panels q, v, a, lambda, sigma (cells of a stage each, rows-by-panels), q_start, v_start, power and dissipated
## (panels-by-stages, W).
##
## The springs' tensions sigma are unknowns of Newton's iteration, as multipliers are: for stiff springs it converges
## then as for the joints that they tend to; otherwise k would multiply what their directions turn within the step.
##
## Newton's matrix is that of each panel's middle stage, or, where @var{whole} is true, of every stage where it is,
## which costs more: where stiff rods turn much within a panel, and beyond a singular position, where the constraints'
## gradients point the other way, one matrix would not do.
## @end deftypefn

function [window, why] = radau_window (system, rule, y, h, panels, guess, tolerance, whole = false)
  s = numel (rule.c);
  x.t = reshape (y.t + h*((0:panels-1).' + rule.c), 1, []);
  x.prescribed = system.prescribed (x.t);
  x.prescribed_middle = at_columns (x.prescribed, (s - 1)/2*panels + (1:panels));
  [x.q, x.v] = guess (x.t);
  every = ones (1, panels*s);
  x.lambda = y.lambda(:,every);
  x.sigma = y.sigma(:,every);
  x.mu = 0*x.lambda;
  window = struct ("converged", false, "iterations", 0, "error_ratio", Inf);
  why = "its Newton iteration did not converge";
  change = rate = NaN;
  do
    window.iterations++;
    if (window.iterations == 1 || (! whole && (window.iterations == 2 && panels > 1 || rate > 0.4)))
      factors = middle_factors (system, rule, h, panels, x);
    endif
    [residual, at] = residual_of (system, rule, h, panels, y, x, factors);
    if (! all (cellfun (@(r) all (isfinite (r(:))), residual)))
      why = "its loads or states are no numbers";
      return;
    endif
    if (whole)
      step = radau_whole_step (system, rule, h, panels, at, x, residual);
    else
      step = radau_step (factors, residual, panels);
    endif
    step = cellfun (@(d) reshape (d, [], panels*s), step, "uniformoutput", false);
    x.q += step{1};
    x.v += step{2};
    x.lambda += step{3}*factors.unit;
    x.mu += step{4}*factors.unit;
    x.sigma += step{5}*factors.unit;
    before = change;
    change = max (max (abs (system.q_points*[step{1}, h*step{2}])))/tolerance;
    rate = change/before;
    met = ! whole || (all (abs (at.constraints.residual)(:) <= 1e-11) && all (abs (at.constraints.velocity)(:) <= 1e-9));
    settled = whole && change <= 0.05 && rate > 1/2;  # as near as rounding lets it, at a singular position
    window.converged = change < 1e-7 || (met && (change*rate <= 1e-3*(1 - rate) || settled));
    left = 15 - window.iterations;
    grows = (change > 1 && rate > 100) || (window.iterations > 3 && change*min (rate, 1)^left > 1);
    hopeless = ! isfinite (change) || left == 0 || grows;
  until (window.converged || hopeless)
  if (window.converged)
    why = "its steps shrank to nothing";
    if (any ([at.power, at.dissipated, at.constraints.rate(:).']))  # the iteration's last step changes them, too
      at = system.at (x.prescribed, x.q, x.v);
    endif
    window.power = reshape (system.work_rate (at, x.lambda), panels, s);
    window = finished (system, window, rule, factors, h, panels, y, x, at, tolerance);
  endif
endfunction

function factors = middle_factors (system, rule, h, panels, x)
  middle = (numel (rule.c) - 1)/2*panels + (1:panels);
  at = system.at (x.prescribed_middle, x.q(:,middle), x.v(:,middle));
  [mass, jacobian, spring_jacobian] = system.matrices (at);
  tangent = system.tangent (at, x.lambda(:,middle), x.sigma(:,middle));
  damping = kron (speye (panels), system.damping_matrix);
  factors = radau_factors (rule, h, mass, tangent, damping, jacobian, spring_jacobian, at.springs, panels);
endfunction

## where panels begin: at y, and where the one before them ends
function x = started (x, y, panels)
  x = [y, x(:,end-panels+1:end-1)];
endfunction

## derivatives by time of the polynomials through a panel's start and stages
function x_dot = rates (rule, h, panels, x, y)
  from_start = reshape (x, [], numel (rule.c)) - started (x, y, panels)(:);
  x_dot = reshape (from_start*rule.inverse.'/h, rows (x), []);
endfunction

## what is left, with the other sign, in the units of radau_matrix
function [residual, at] = residual_of (system, rule, h, panels, y, x, factors)
  at = system.at (x.prescribed, x.q, x.v);
  u = rates (rule, h, panels, x.q, y.q);
  a = rates (rule, h, panels, x.v, y.v);
  excess = x.sigma - at.springs.tension;
  residual = {-system.inertia(at, u - x.v) - system.reaction(at, x.mu)
              at.force - system.inertia(at, a) - system.reaction(at, x.lambda) - system.spring_reaction(at, excess)
              -at.constraints.residual*factors.unit/h
              -at.constraints.velocity*factors.unit
              -factors.compliance(:,rem (0:columns (excess)-1, panels) + 1).*excess};
endfunction

function window = finished (system, window, rule, factors, h, panels, y, x, at, tolerance)
  s = numel (rule.c);
  x.a = rates (rule, h, panels, x.v, y.v);
  start = struct ("q", started (x.q, y.q, panels), "v", started (x.v, y.v, panels), "a", started (x.a, y.a, panels));
  window.q_start = start.q;
  window.v_start = start.v;
  window.error_ratio = radau_error (system, rule, factors, h, x, start, tolerance);
  for name = {"q", "v", "a", "lambda", "sigma"}
    window.(name{1}) = mat2cell (x.(name{1}), rows (x.(name{1})), panels*ones (1, s));
  endfor
  window.dissipated = reshape (at.dissipated, panels, s);
endfunction

%!function [window, y] = from_start (h, panels, tolerance, y = [], varargin)
%!  [system, start] = sample_mechanism ([0 1]);
%!  if (isempty (y))
%!    y = setfield (start, "t", 0);
%!    [y.a, y.lambda, at] = constrained_accelerations (system, 0, y.q, y.v);
%!    y.sigma = at.springs.tension;
%!  endif
%!  still = @(t) deal (repmat (start.q, size (t)), repmat (start.v, size (t)));
%!  window = radau_window (system, radau_rule (5), y, h, panels, still, tolerance, varargin{:});
%!endfunction
%!test # windows of one and of three panels leave the same state, on its constraints
%! [window, y] = from_start (0.002, 3, 1e-9);
%! assert (window.converged);
%! for p = 1:3
%!   one = from_start (0.002, 1, 1e-9, y);
%!   for name = {"q", "v", "a", "lambda", "sigma"}
%!     y.(name{1}) = one.(name{1}){5};
%!   endfor
%!   y.t += 0.002;
%!   assert (y.q, window.q{5}(:,p), 1e-11);
%!   assert (y.v, window.v{5}(:,p), 1e-9);
%!   assert (one.error_ratio, window.error_ratio(p), 1e-2*window.error_ratio(p));
%! endfor
%! at = sample_mechanism ([0 1]).at (y.t, y.q, y.v);
%! assert (abs (at.constraints.residual) < 1e-10); assert (abs (at.constraints.velocity) < 1e-8);
%!test # of one panel, with every stage's own matrix
%! q = @(whole) from_start (0.01, 1, 1e-9, [], whole).q{5};
%! assert (q (true), q (false), 1e-11);
%!test # however small the tolerance is against what the first guess is off by
%! assert (from_start (0.01, 3, 1e-13).converged);
