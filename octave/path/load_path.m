## -*- texinfo -*-
## @deftypefn {} {@var{found} =} load_path (@var{kind}, @var{scene}, @var{t}, @var{factors}, @var{left})
## The equilibria of a checked scene of a @var{kind} (see @code{kind_of}) as its loads at the time @var{t} (s) grow
## (see @code{growing_loads}): from the first of the rising @var{factors} to the last, one path along its arc, through
## limit points, snap-through and snap-back (see @code{follow_path}), while there is time @var{left} () (s). Modes that
## are not stated are as many as places within 1e-4 take in the first equilibrium, in the last where there is one (see
## @code{at_rest}), and before the first event (see @code{richer_path}).
##
## @var{found} is a struct of functions (how many of each sort, NaN: stated), end (a text: why the path ends), and, a
## column a point, each given factor and each event among them: factor, square (1/s^2, of the slowest undamped
## vibration, negative where it grows), stable and event (its number, 0 for none); shape, a cell a body of places (a
## page a point, see @code{mechanism_at_rest}); and events, a struct array of factor, what ("limit point",
## "bifurcation" or "flutter") and mode, the shape moved along what turns, by an eighth of its extent (a cell array of
## lines).
## @end deftypefn

function found = load_path (kind, scene, t, factors, left = @() Inf)
  scene = growing_loads (scene, t);
  rich = rich_enough (kind, scene, factors);
  do
    [path, first] = first_point (rich, factors);
    [points, found.end] = follow_path (path, first, left);
    points = [points{:}];
    rich = richer_path (kind, scene, path, points);
  until (isempty (rich) || left () < 0)
  found.functions = path.functions;
  found.factor = [points.x](end,:);
  found.square = arrayfun (@(point) point.squares(1), points);
  found.stable = [points.unstable] == 0;
  found.shape = path.balance.shape ([points.x](1:end-1,:));
  is_event = ! cellfun (@isempty, {points.event});
  found.event = cumsum (is_event).*is_event;
  found.events = struct ("factor", {}, "what", {}, "mode", {});
  for k = find (is_event)
    [~, ~, mode] = pushed_lines (path.balance, points(k).x(1:end-1), points(k).turns);
    found.events(end+1) = struct ("factor", found.factor(k), "what", points(k).event, "mode", {mode});
  endfor
endfunction

function [path, point] = first_point (rich, factors)
  path = struct ("factors", factors, "range", range (factors));
  path.functions = rich.functions;
  path.balance = rich.balance;
  [q, lambda] = equilibrium (path.balance, factors(1));
  places = vertcat (path.balance.shape (q){:});
  path.size = max ([range(places), path.balance.length]);
  path.mass = mass_of_displacement (path.balance, q);
  ahead = [zeros(path.balance.n, 1); 1];
  point = path_point (path, [q; factors(1)], lambda, ahead);
  point.tangent = path_tangent (point, ahead);
endfunction

## for the first equilibrium, and for the last where there is one
function found = rich_enough (kind, scene, factors)
  places = @(found) vertcat (found.balance.shape (found.q){:})(:).';
  found = at_rest (kind, scene, factors(1), places, 1e-4);
  try
    last = at_rest (kind, scene, factors(end), places, 1e-4);
  catch err
    rethrow_others (err, "toolchain:scene");
    return;
  end_try_catch
  if (last.functions > found.functions)
    found.functions = last.functions;
    found.balance = balance_near (kind, scene, kind.sized (scene, last.functions), found);
  endif
endfunction

## the largest, kg per square of the displacement that goes with a coordinate
function mass = mass_of_displacement (balance, q)
  unit = eye (balance.n);
  metres = arrayfun (@(k) balance.size (unit(:,k)), 1:balance.n).';
  mass = max (diag (balance.mass (q))./metres.^2);
endfunction

%!function scene = column (joints, F)   # of 1 m along x, under an end force of F N
%!  rod = struct ("length", 1, "EA", 1e7, "EI", 2, "rhoA", 1, "half_height", 0.01);
%!  scene.bodies = {struct("rod", rod, "model", struct ("energy", "uniaxial", "rotary_inertia", false))};
%!  scene.joints = [joints, {struct("kind", "force", "bodies", 1, "stations", 1, "value", [-F 0])}];
%!  [scene.gravity, scene.duration] = deal (0, 1);
%!  scene = check_mechanism (scene);
%!endfunction
%!test # Euler's loads: hinged, clamped and free, clamped at both ends
%! at = @(kind, s, varargin) struct ("kind", kind, "bodies", 1, "stations", s, varargin{:});
%! guide = at ("slider", 1, "point", [0 0], "direction", 0);
%! upright = at ("angle", 1, "value", 0);
%! ends = {{at("revolute", 0), guide}, {at("weld", 0)}, {at("weld", 0), guide, upright}};
%! for k = 1:3
%!   found = load_path (mechanism_kind (), column (ends{k}, [1 1/4 4](k)*pi^2*2), 0, [0 1.2]);
%!   assert ({found.events.what}, {"bifurcation"}); assert (found.events.factor, 1, 1e-4);
%!   straight = 1:find (found.event);
%!   assert (squeeze (found.shape{1}(end,2,straight)), zeros (numel (straight), 1), 1e-9);
%!   assert (norm (found.events.mode{1}(:,2)) > 0.1); assert (max (abs (found.shape{1}(:,2,end))) > 0.1);
%! endfor

%!test # a column over three bearings: its spans' moments balance (Timoshenko and Gere, section 2.9)
%! spans = [0.1 0.9];
%! balance = @(k) sum (spans.*(1 - k*spans./tan (k*spans))./(k*spans).^2);
%! at = @(s) struct ("kind", "slider", "bodies", 1, "stations", s, "point", [s 0], "direction", 0);
%! hinge = struct ("kind", "revolute", "bodies", 1, "stations", 0);
%! F = 2*fzero (balance, [4.5 6.1])^2;
%! found = load_path (mechanism_kind (), column ({hinge, at(0.1), at(1)}, F), 0, [0 0.6 1.2]);
%! assert (found.events(1).what, "bifurcation"); assert (found.events(1).factor, 1, 3e-4);
%!test # two bars as a flat roof (von Mises 1923): F = 2 EA h (1/L - 1/l), the most where L^3 = a^2 l, and back
%! [scene, F, height] = flat_roof ();
%! found = load_path (mechanism_kind (), scene, 0, [0 0.5 1.1]);
%! assert ({found.events.what}, {"limit point", "limit point"}); assert ([found.events.factor], [1 -1], 1e-7);
%! y = squeeze (found.shape{1}(end,2,:)).';
%! assert (F (y), found.factor, 1e-7);
%! assert (abs (y([1 end])), [height, abs(fzero (@(y) F (y) - 1.1, [-1.5 -1.01]*height))], 1e-7);
%! assert (sum (abs (found.factor - 0.5) < 1e-12), 3);  # on the way up, down, and beyond
%! between = cumsum (found.event > 0) == 1;
%! assert (found.stable(2:end-1), ! between(2:end-1) | found.event(2:end-1) > 0);

%!function tip = elastica (force)   # of a cantilever, Bisshopp and Drucker, Quart. Appl. Math. 3, 1945
%!  K = @(k) ellipke (k^2);
%!  part = @(k) asin (1/(k*sqrt (2)));
%!  F = @(k) K (k) - quadgk (@(x) 1./sqrt (1 - k^2*sin (x).^2), 0, part (k), "RelTol", 1e-13);
%!  E = @(k) quadgk (@(x) sqrt (1 - k^2*sin (x).^2), part (k), pi/2, "RelTol", 1e-13);
%!  k = fzero (@(k) F (k) - sqrt (force), [0.70711, 0.99999], optimset ("TolX", 1e-15));
%!  tip = [sqrt(2*(2*k^2 - 1)/force), 1 - 2/sqrt(force)*E(k)];
%!endfunction
%!test # the elastica under P l^2/EI = 1 ... 10 by the exact rod, that stretches by 1e-8 at most
%! scene = setfield (plane_rods ({"clamped", "free"}, [20 20]), "force", [0 1 0]);
%! scene.rod.EA = 1e9;
%! found = load_path (surface_kind (), check_surface_scene (scene), 0, 0:10);
%! for force = 1:10
%!   assert (found.shape{1}(end,1:2,found.factor == force), elastica (force), 1e-8);
%! endfor
%! assert (isempty (found.events)); assert (found.stable, true (size (found.factor)));

%!test # beyond Euler's load: 1.0637 times it bends the free end by 40 degrees (Timoshenko and Gere, table 2-4)
%! scene = setfield (plane_rods ({"clamped", "free"}, [12 12]), "force", [-pi^2/4 0 0]);
%! found = load_path (surface_kind (), check_surface_scene (scene), 0, [0 1 1.0637]);
%! assert (found.events.factor, 1, 1e-5); assert (found.stable, true (size (found.factor)));
%! tip = diff (found.shape{1}([end-1 end],1:2,end));
%! assert (atan2d (abs (tip(2)), tip(1)), 40, 0.1);
%!test # Euler's load of a column of welded pieces, that stays straight while its weld bears more
%! body = struct ("rod", struct ("length", 0.5, "EA", 1e6, "EI", 1, "rhoA", 1, "rhoI", 0), ...
%!                "initial", struct ("phi", pi/2), "model", struct ("energy", "uniaxial"));
%! scene = struct ("bodies", {{body, body}}, "gravity", 0, "duration", 1);
%! scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)
%!                 struct("kind", "weld", "bodies", [2 1], "stations", [0 0.5])
%!                 struct("kind", "force", "bodies", 2, "stations", 0.5, "value", [0 -1])};
%! found = load_path (mechanism_kind (), check_mechanism (scene), 0, 0:0.25:3);
%! assert (found.events(1).what, "bifurcation"); assert (found.events(1).factor, pi^2/4, 1e-4);
