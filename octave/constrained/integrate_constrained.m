## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{count}] =} integrate_constrained (@var{system}, @var{times}, @var{start}, @var{solver})
## The states of a mechanism (see @code{mechanism_system}) at the @var{times} (1-by-m, s), from the state @var{start}, by
## the method @var{solver}.name of @code{constrained_table}; "auto" is "radau".  Between two breaks of the loads every
## interval is integrated for itself.
##
## @var{states}: q, v (n-by-m), lambda (constraints-by-m), W, D (1-by-m).  @var{count}: method, steps, calls, seconds.
## @end deftypefn

function [states, count] = integrate_constrained (system, times, start, solver)
  table = constrained_table ();
  method = table(strcmp (strrep (solver.name, "auto", "radau"), {table.name}));
  states = first_states (system, times, start);
  breaks = system.breaks(system.breaks > times(1) & system.breaks < times(end));
  ends = [times(1), breaks, times(end)];
  [clock, steps, y] = deal (tic (), 0, start);
  watch_rate (times(end));
  for k = 1:(numel (ends) - 1)*(ends(end) > ends(1))
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
endfunction

## loads from inside an interval, and every state counted
function system = within (system, interval)
  inside = interval + [1, -1].*eps (interval);
  at = system.at;
  system.at = @(t, q, v) at (watch_rate (t(end), min (max (t, inside(1)), inside(2))), q, v);
endfunction
