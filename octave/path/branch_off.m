## -*- texinfo -*-
## @deftypefn {} {@var{side} =} branch_off (@var{path}, @var{event})
## The first point, with its tangent, of the branch that leaves a @var{path} at the bifurcation @var{event} (see
## @code{path_events}): a fiftieth of a rod along the vibration that does not come back there, or against it, whichever
## is more stable, along it where they are alike; empty where neither is found.
## @end deftypefn

function side = branch_off (path, event)
  away = [event.turns; 0]/sqrt (event.turns.'*event.metric(1:end-1,1:end-1)*event.turns);
  side = [];
  for way = [1 -1]
    x = event.x + way*path.size/50*away;
    found = path_point (path, x, event.lambda, event.metric*away);
    if (! isempty (found) && (isempty (side) || found.unstable < side.unstable))
      side = found;
    endif
  endfor
  if (! isempty (side))
    side.tangent = path_tangent (side, side.x - event.x);
  endif
endfunction

%!test # a column of one hinge: factor = q/sin (q), stable, with the tangent away from the upright
%! path = sprung_column ();
%! event = setfield (path_point (path, [0; 1], zeros (0, 1), [0; 1]), "turns", 3);
%! side = branch_off (path, event);
%! assert (side.x, [0.02; 0.02/sin(0.02)], 1e-10); assert (side.unstable, 0); assert (side.tangent(1) > 0.9);
%!test # of two sides the stable one
%! path = sprung_column ();
%! path.balance.residual = @(factor, q, v, lambda) factor.*q - q - q.^2;
%! path.balance.tangent = @(factor, q, lambda) 1 + 2*q - factor;
%! event = setfield (path_point (path, [0; 1], zeros (0, 1), [0; 1]), "turns", -1);
%! assert (branch_off (path, event).x, [0.02; 1.02], 1e-10);
