## -*- texinfo -*-
## @deftypefn {} {@var{rich} =} richer_path (@var{kind}, @var{scene}, @var{path}, @var{points})
## What a @var{path} that was followed through its @var{points} (see @code{follow_path}) needs more: a struct of twice
## as many functions and of their balance, where places then differ by more than a thousandth of the path's size a
## little before its first event, or its end, or are not found; else, and where the functions are stated, empty.
## @end deftypefn

function rich = richer_path (kind, scene, path, points)
  rich = [];
  if (isnan (path.functions) || path.functions >= path.balance.most)
    return;
  endif
  before = find (! cellfun (@isempty, {points.event}), 1);
  last = round (0.8*[before, numel(points)](1));
  at = points(max (last, 1)).x;
  model = kind.sized (scene, 2*path.functions);
  near = balance_near (kind, scene, model, struct ("balance", path.balance, "q", at(1:end-1)));
  places = @(balance, q) vertcat (balance.shape (q){:});
  off = Inf;
  try
    off = max (abs (places (near, equilibrium (near, at(end))) - places (path.balance, at(1:end-1)))(:));
  catch err
    rethrow_others (err, "toolchain:scene");
  end_try_catch
  if (off > 1e-3*path.size)
    rich = struct ("functions", 2*path.functions, "balance", kind.at_rest (scene, model));
  endif
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
