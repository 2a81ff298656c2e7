## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{count}] =} integrate_constrained (@var{system}, @var{times}, @var{start}, @
##   @var{solver})
## The states of a mechanism (see @code{mechanism_system}) at the @var{times} (1-by-m, s), from the state @var{start},
## by the method @var{solver}.name of @code{constrained_table}; "auto" is "radau".  Between two breaks of the loads
## every interval is integrated for itself.
##
## @var{states}: q, v (n-by-m), lambda (constraints-by-m), W, D (1-by-m).  @var{count}: method, steps, calls, seconds,
## still (see @code{stays}).
## @end deftypefn

function [states, count] = integrate_constrained (system, times, start, solver)
  table = constrained_table ();
  method = table(strcmp (strrep (solver.name, "auto", "radau"), {table.name}));
  states = first_states (system, times, start);
  [times, ends] = meet_breaks (times, system.breaks);
  [clock, steps, y] = deal (tic (), 0, start);
  watch_rate (times(end));
  for k = 1:numel (ends) - 1
    inside = times >= ends(k) & times <= ends(k+1);
    stops = unique ([ends(k), times(inside), ends(k+1)]);
    [reached, taken] = method.run (within (system, ends([k k+1])), stops, y, solver);
    at = ismember (stops, times(inside));
    for name = fieldnames (states).'
      states.(name{1})(:,inside) = reached.(name{1})(:,at);
      y.(name{1}) = reached.(name{1})(:,end);
    endfor
    steps += taken;
  endfor
  count = struct ("method", method.name, "steps", steps, "calls", watch_rate (), "seconds", toc (clock));
  count.still = stays (states.q, system.q_scale, solver.tolerance);
endfunction

## loads from inside an interval, and every state counted
function system = within (system, interval)
  inside = inside_of (interval);
  at = system.at;
  system.at = @(t, q, v) at (watch_rate (t(end), min (max (t, inside(1)), inside(2))), q, v);
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
%!test # a load's break is met: M = 1 N m until t = 0.1 s does the work M phi
%! system = pendulum ();
%! system.mechanism.loads = struct ("value", @(t) t < 0.1, "parts", 3, "first", 1, "second", 2);
%! system = mechanism_system (struct ("duration", 1, "breaks", 0.1), system.mechanism);
%! start = struct ("q", zeros (3, 1), "v", zeros (3, 1), "W", 0, "D", 0);
%! [states, count] = integrate_constrained (system, [0 0.1 0.5], start, struct ("name", "auto", "tolerance", 1e-9));
%! assert (states.W(2:3), states.q(1,2)*[1 1], 1e-9);
%! assert (count.method, "radau");
