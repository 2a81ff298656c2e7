## -*- texinfo -*-
## @deftypefn {} {@var{rich} =} richer_path (@var{kind}, @var{scene}, @var{path}, @var{points})
## What a @var{path} that was followed through its @var{points} (see @code{follow_path}) needs more: a struct of twice
## as many functions and of their balance, where a little before its first event, or its end, places then differ by
## more than a thousandth of the path's size, or are not found, or where the square of the slowest frequency, which
## falls as a line to the event, moves that by 5e-4 of its factor; else, and where the functions are stated, empty.
## @end deftypefn

function rich = richer_path (kind, scene, path, points)
  rich = [];
  if (isnan (path.functions) || path.functions >= path.balance.most)
    return;
  endif
  event = find (! cellfun (@isempty, {points.event}), 1);
  point = points(max (round (0.8*[event, numel(points)](1)), 1));
  model = kind.sized (scene, 2*path.functions);
  [q, factor] = deal (point.x(1:end-1), point.x(end));
  near = balance_near (kind, scene, model, struct ("balance", path.balance, "q", q));
  places = @(balance, q) vertcat (balance.shape (q){:});
  [off, moved] = deal (Inf, 0);
  try
    [richer, ~, linear] = equilibrium (near, factor);
    off = max (abs (places (near, richer) - places (path.balance, q))(:));
    if (! isempty (event) && point.squares(1) > 0)
      moved = (1 - slowest_square (linear)/point.squares(1))*(points(event).x(end) - factor);
    endif
  catch err
    rethrow_others (err, "toolchain:scene");
  end_try_catch
  if (off > 1e-3*path.size || abs (moved) > 5e-4*abs (factor))
    rich = struct ("functions", 2*path.functions, "balance", kind.at_rest (scene, model));
  endif
endfunction

function square = slowest_square (linear)
  square = min ([Inf, vibrations(setfield (linear, "C", 0*linear.M)).omega]).^2;
endfunction

%!test # the deep arch, of which a few polynomials are too stiff where it sways, and a rod that is pulled straight
%! scene = setfield (arch (), "model", "modes", "auto");
%! kind = surface_kind ();
%! scene = growing_loads (check_surface_scene (scene), 0);
%! path = struct ("functions", 8, "balance", kind.at_rest (scene, kind.sized (scene, 8)), "size", 2);
%! [q, lambda] = equilibrium (path.balance, 6);
%! rich = richer_path (kind, scene, path, struct ("x", [q; 6], "event", ""));
%! assert (rich.functions, 16);
%! assert (richer_path (kind, scene, setfield (path, "functions", NaN), struct ("x", [q; 6], "event", "")), []);
%! scene = growing_loads (check_surface_scene (setfield (plane_rods ({"hinge", "free"}, [8 8]), "force", [1 0 0])), 0);
%! path.balance = kind.at_rest (scene, kind.sized (scene, 8));
%! assert (richer_path (kind, scene, path, struct ("x", [equilibrium(path.balance, 1); 1], "event", "")), []);
