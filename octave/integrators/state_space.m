## -*- texinfo -*-
## @deftypefn {} {@var{ode} =} state_space (@var{system}, @var{correction})
## A mechanism (see @code{mechanism_system}) as a system of first order in y = (q; v; W; D), as the integrators of
## @code{integrator_table} take it: accelerations from Phi'' = @var{correction} (constraints), by default 0.
## Further fields: pack (state) = y, unpack (t, y) = state with q, v, lambda, W and D, of as many columns as y.
## @end deftypefn

function ode = state_space (system, correction = @(constraints) 0)
  n = system.n;
  ode = struct ("mass", system.mass, "stiffness", system.stiffness, "duration", system.duration, ...
                "constrained", system);
  energy = 1;
  ode.state_scale = [system.q_scale; system.q_scale/(0.1*system.duration); energy; energy];
  ode.rate = @(t, y) rate (t, y, system, correction);
  ode.pack = @(state) [state.q; state.v; state.W; state.D];
  ode.unpack = @(t, y) unpack (t, y, system, correction);
  if (isfield (system, "calls"))
    ode.calls = system.calls;
  endif
endfunction

function y_dot = rate (t, y, system, correction)
  n = system.n;
  [a, lambda, at] = constrained_accelerations (system, t, y(1:n,:), y(n+1:2*n,:), correction);
  y_dot = [y(n+1:2*n,:); a; system.work_rate(at, lambda); at.dissipated];
endfunction

function state = unpack (t, y, system, correction)
  n = system.n;
  state = struct ("q", y(1:n,:), "v", y(n+1:2*n,:), "W", y(end-1,:), "D", y(end,:));
  [~, state.lambda] = constrained_accelerations (system, t, state.q, state.v, correction);
endfunction

%!test # the rates are those of the packed state
%! [system, start] = sample_mechanism ([0 1]);
%! ode = state_space (system);
%! y_dot = ode.rate (0.1, ode.pack (start));
%! assert (y_dot(1:system.n), start.v);
%! assert (ode.unpack (0.1, ode.pack (start)).q, start.q);
%!test # states of two times are unpacked as each of them
%! [system, start] = sample_mechanism ([0 1]);
%! ode = state_space (system);
%! y = [ode.pack(start), 1.1*ode.pack(start)];
%! both = ode.unpack ([0.1 0.2], y);
%! for [rows_of_both, name] = both
%!   each = [ode.unpack(0.1, y(:,1)).(name), ode.unpack(0.2, y(:,2)).(name)];
%!   assert (rows_of_both, each, 1e-12*norm (each));
%! endfor
