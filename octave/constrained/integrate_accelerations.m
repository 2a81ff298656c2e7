## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_accelerations (@var{how}, @var{system}, @var{times}, @var{start}, @var{solver})
## The mechanism's accelerations, index 1, by ode45 with @var{solver}.tolerance (m), or in steps of @var{solver}.step.
##
## @var{how} is "acceleration": Phi'' = 0 alone, from which Phi drifts as the square of time; "baumgarte": Phi'' + 2 r Phi' +
## r^2 Phi = 0 with r = @var{solver}.baumgarte (1/s; Baumgarte, Comput. Methods Appl. Mech. Eng. 1, 1972); "projection":
## positions and velocities are brought back onto their constraints, in the mass metric, at each of the @var{times}.
## @end deftypefn

function [states, steps] = integrate_accelerations (how, system, times, start, solver)
  correction = @(constraints) 0;
  if (strcmp (how, "baumgarte"))
    r = solver.baumgarte;
    correction = @(constraints) -2*r*constraints.velocity - r^2*constraints.residual;
  endif
  ode = state_space (system, correction);
  solver.tolerance /= 100;
  states = first_states (system, times, start);
  states.lambda(:,1) = ode.unpack (times(1), ode.pack (start)).lambda;
  y = ode.pack (start);
  steps = 0;
  for k = 2:numel (times)
    [reached, taken] = integrate_explicit (@ode45, ode, times([k-1 k]), y, solver);
    y = reached(:,end);
    if (strcmp (how, "projection"))
      state = ode.unpack (times(k), y);
      state.q = project_positions (system, times(k), state.q);
      state.v = project_velocities (system, times(k), state.q, state.v);
      y = ode.pack (state);
    endif
    states = keep (states, k, ode.unpack (times(k), y));
    steps += taken;
  endfor
endfunction
