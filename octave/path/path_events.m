## -*- texinfo -*-
## @deftypefn {} {[@var{events}, @var{shares}] =} path_events (@var{path}, @var{point}, @var{next})
## The points of a @var{path} (see @code{path_point}) between a @var{point} and the @var{next} one where the number of
## vibrations that grow changes, in order (a cell array), with the @var{shares} of the way there (see
## @code{path_cubic}): each with event, a text, and turns (n-by-1), the vibration that does not come back there, ahead
## along the path if it turns round.
##
## It is a "limit point", where the factor turns round, if the load works along turns, else a "bifurcation" of
## equilibria (Wriggers and Simo, IJNME 30, 1990); and "flutter" if what grows beyond it oscillates.
## @end deftypefn

function [events, shares] = path_events (path, point, next)
  turning = point.unstable+1:next.unstable;
  if (next.unstable < point.unstable)
    turning = next.unstable+1:point.unstable;
  endif
  events = cell (size (turning));
  shares = zeros (size (turning));
  for j = 1:numel (turning)
    [event, shares(j)] = located (path, point, next, turning(j));
    events{j} = named_event (event, turning(j), [point, next]);
  endfor
  [shares, order] = sort (shares);
  events = events(order);
endfunction

## halved fourteen times, then on the chord: at a bifurcation itself the plane across the tangent leaves a point free
function [event, share] = located (path, point, next, k)
  cubic = path_cubic (point, next);
  ends = {point, next};
  shares = [0 1];
  for halving = 1:14
    share = mean (shares);
    middle = path_point (path, cubic*[share^3; share^2; share; 1], ...
                         point.lambda + share*(next.lambda - point.lambda), point.metric*point.tangent);
    if (isempty (middle))
      break;
    endif
    side = 1 + ((middle.squares(k) > 0) == (ends{2}.squares(k) > 0));
    ends{side} = middle;
    shares(side) = share;
  endfor
  part = ends{1}.squares(k)/(ends{1}.squares(k) - ends{2}.squares(k));
  part = min (max (part, 0), 1);  # nought at the first, and less for rounding
  event = ends{1 + (part > 0.5)};
  event.x = ends{1}.x + part*(ends{2}.x - ends{1}.x);
  event.lambda = ends{1}.lambda + part*(ends{2}.lambda - ends{1}.lambda);
  event.squares(k) = 0;
  share = shares(1) + part*diff (shares);
endfunction

function event = named_event (event, k, ends)
  event.turns = event.modes(:,k);
  [~, largest] = max (abs (event.turns));
  way = event.turns(largest);
  load = event.linear.basis.'*event.load;
  if (any ([ends(1).flutters(k), ends(2).flutters(k)]))
    event.event = "flutter";
  elseif (abs (event.turns.'*event.load) > 1e-5*sqrt (load.'*(event.linear.M \ load)))
    event.event = "limit point";
    way = event.turns.'*event.linear.mass*(ends(2).x - ends(1).x)(1:end-1);
  else
    event.event = "bifurcation";
  endif
  event.turns *= sign (way);
endfunction

%!function [path, points] = points_at (path, x)
%!  for k = 1:columns (x)
%!    points{k} = path_point (path, x(:,k), zeros (0, 1), [0; 1]);
%!    points{k}.tangent = [0; 1];
%!  endfor
%!endfunction
%!test # an upright column: a bifurcation at 1 N, from both sides, and none before
%! [path, points] = points_at (sprung_column (), [0 0 0; 0.5 0.9 1.2]);
%! events = path_events (path, points{2}, points{3});
%! assert (events{1}.x, [0; 1], 1e-10); assert ({events{1}.event, events{1}.turns}, {"bifurcation", 1});
%! assert (path_events (path, points{3}, points{2}){1}.x(2), 1, 1e-10);
%! assert (path_events (path, points{1}, points{2}), cell (1, 0));
%!test # one that leans to the other side turns round where factor*cos (q) = 1
%! path = sprung_column (-0.1);
%! q = fzero (@(q) tan (q) - (q + 0.1), [0.1 1.2]);
%! at = @(q) path_point (path, [q; (q + 0.1)/sin(q)], zeros (0, 1), [1; 0]);
%! [point, next] = deal (at (q - 0.02), at (q + 0.02));
%! [point.tangent, next.tangent] = deal (path_tangent (point, [1; 0]), path_tangent (next, [1; 0]));
%! events = path_events (path, point, next);
%! assert (events{1}.event, "limit point"); assert (events{1}.x, [q; 1/cos(q)], 1e-8);
%!test # two columns that straighten one soon after the other, as what presses them lets go
%! at = @(kind, body, s, varargin) struct ("kind", kind, "bodies", body, "stations", s, varargin{:});
%! on = @(body, y) {at("revolute", body, 0, "point", [0 y]), ...
%!                  at("slider", body, 1, "point", [0 y], "direction", 0), at("force", body, 1, "value", [pi^2 0])};
%! column = @(EI, y) struct ("rod", struct ("length", 1, "EA", 1e6, "EI", EI, "rhoA", 1), "initial", struct ("y", y), ...
%!                           "model", struct ("modes", [0 1], "stiffening", "foreshortening"));
%! scene.bodies = {column(1, 0), column(1.0001, 1)};
%! scene.joints = [on(1, 0), on(2, 1)];
%! [scene.gravity, scene.duration] = deal (0, 1);
%! found = load_path (mechanism_kind (), check_mechanism (scene), 0, [-1.3 -0.5]);
%! assert ([found.events.factor], [-1.0001 -1], 1e-5); assert (found.stable([1 end]), [false true]);
