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

%!function system = pendulum ()   # a rigid rod of 1 m, let go from the horizontal
%!  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 2), ...
%!                         "model", struct ("modes", [0 0]))};
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%!  scene.duration = 1;
%!  scene = check_mechanism (scene);
%!  system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%!endfunction
%!function [phi, states] = turned (name, t, field = "tolerance", value = 1e-8)
%!  system = pendulum ();
%!  solver = struct ("name", name, "tolerance", 1e-8, "step", [], "rho_infinity", 0.9, "baumgarte", 50);
%!  start = struct ("q", zeros (3, 1), "v", zeros (3, 1), "W", 0, "D", 0);
%!  states = integrate_constrained (system, t, start, setfield (solver, field, value));
%!  phi = states.q(1,:);
%!endfunction
%!function phi = exact (t)   # by the elliptic function: phi_ddot = -3/2 g/l cos (phi) from rest at 0
%!  omega = sqrt (1.5*9.81);
%!  [sn, ~, ~] = ellipj (ellipke (0.5) - omega*t, 0.5);
%!  phi = -pi/2 + 2*asin (sqrt (0.5)*sn);
%!endfunction
%!test # with projection and with Baumgarte's terms as exact as asked
%! for name = {"projection", "baumgarte"}
%!   assert (turned (name{1}, [0 0.8])(2), exact (0.8), 1e-7);
%! endfor
%!function residual = drift (name)
%!  [system, start] = sample_mechanism ([0 0]);
%!  solver = struct ("name", name, "tolerance", 1e-3, "baumgarte", 50);
%!  states = integrate_constrained (system, [0 0.5], start, solver);
%!  residual = max (abs (system.at (0.5, states.q(:,2), states.v(:,2)).constraints.residual));
%!endfunction
%!test # without stabilisation the constraints drift, with projection they do not
%! assert (drift ("acceleration") > 1e-9);
%! assert (drift ("projection") < 1e-11);
