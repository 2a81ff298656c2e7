## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{steps}] =} integrate_constrained_steps (@var{method}, @var{system}, @
##   @var{times}, @var{start}, @var{solver})
## A method of order 2 in equal steps through all @var{times}, by @code{integrate_fixed}: steps of @var{solver}.step,
## or halved until they meet @var{solver}.tolerance.
## @end deftypefn

function [states, steps] = integrate_constrained_steps (method, system, times, start, solver)
  ode = state_space (system);
  [reached, steps] = integrate_fixed (method, 2, ode, times, ode.pack (start), solver);
  states = first_states (system, times, start);
  for k = 1:numel (times)
    states = keep (states, k, ode.unpack (times(k), reached(:,k)));
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
%!test # order 2 of both methods
%! for name = {"generalized_alpha", "variational"}
%!   error = @(h) turned (name{1}, [0 0.8], "step", h)(2) - exact (0.8);
%!   assert (log2 (error (0.02)/error (0.01)), 2, 0.1);
%! endfor
