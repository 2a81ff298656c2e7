## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_accelerations (@var{how}, @var{system}, @var{times}, @
##   @var{start}, @var{solver})
## The mechanism's accelerations, index 1, by ode45 with @var{solver}.tolerance (m), or in steps of @var{solver}.step.
##
## @var{how} is "acceleration": Phi'' = 0 alone, from which Phi drifts as the square of time; "baumgarte": Phi'' +
## 2 r Phi' + r^2 Phi = 0 with r = @var{solver}.baumgarte (1/s; Baumgarte, Comput. Methods Appl. Mech. Eng. 1,
## 1972); "projection": positions and velocities are brought back onto their constraints, in the mass metric, at
## each of the @var{times}.
## @end deftypefn

function [states, steps] = integrate_accelerations (how, system, times, start, solver)
  correction = @(constraints) 0;
  if (strcmp (how, "baumgarte"))
    r = solver.baumgarte;
    correction = @(constraints) -2*r*constraints.velocity - r^2*constraints.residual;
  endif
  ode = state_space (system, correction);
  solver.tolerance /= 100;
  reached = ode.pack (start);
  steps = 0;
  for k = 2:numel (times)
    [stops, taken] = integrate_explicit (@ode45, ode, times([k-1 k]), reached(:,k-1), solver);
    y = stops(:,end);
    if (strcmp (how, "projection"))
      state = ode.unpack (times(k), y);
      state.q = project_positions (system, times(k), state.q);
      state.v = project_velocities (system, times(k), state.q, state.v);
      y = ode.pack (state);
    endif
    reached(:,k) = y;
    steps += taken;
  endfor
  states = ode.unpack (times, reached);
endfunction

%!test # with projection and with Baumgarte's terms as exact as asked
%! for name = {"projection", "baumgarte"}
%!   assert (swing_pendulum (name{1}, [0 0.8])(2), pendulum_angle (0.8), 1e-7);
%! endfor
%!function residual = drift (name)
%!  [system, start] = sample_mechanism ([0 0]);
%!  solver = struct ("name", name, "tolerance", 1e-3, "baumgarte", 50);
%!  states = integrate_constrained (system, [0 0.5], start, solver);
%!  residual = max (abs (system.at (0.5, states.q(:,2), states.v(:,2)).constraints.residual));
%!endfunction
%!test # the multipliers at the start, too
%! [system, start] = sample_mechanism ([0 0]);
%! solver = struct ("name", "acceleration", "tolerance", 1e-3);
%! states = integrate_constrained (system, [0 0.01], start, solver);
%! [~, lambda] = constrained_accelerations (system, 0, start.q, start.v);
%! assert (states.lambda(:,1), lambda, 1e-9*max (abs (lambda))); assert (norm (lambda) > 0.01);
%!test # without stabilisation the constraints drift, with projection they do not
%! assert (drift ("acceleration") > 1e-9);
%! assert (drift ("projection") < 1e-11);
