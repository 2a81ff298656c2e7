## -*- texinfo -*-
## @deftypefn {} {@var{run} =} far_richer (@var{result}, @var{seconds})
## What the scene of a @var{result} of @code{driver} truly does: geometrically exact rods where there are such and they
## converge in so many @var{seconds} (60; see @code{exact_runs}), or else a far richer model of the same physics
## (see @code{richest_run}), its points moved by what all such models drop (see @code{dropped_error}), as the next
## richer model of the ladder has it: more modes than that do not change it, but take a long time.
## @end deftypefn

function run = far_richer (result, seconds = 60)
  scene = result.scene;
  kind = kind_of (scene);
  sharper = setfield (scene, "solver", "tolerance", scene.solver.tolerance/4);
  evalc ("[run, converged] = exact_runs (kind, sharper, seconds);");
  if (converged)
    return;
  endif
  scene.solver.tolerance /= 20;
  like = result;
  if (isfield (result.model, "rung"))
    ladder = ladder_of (kind, scene);
    like = ladder.trial (ladder.richer (result.model.rung), []);
  endif
  dropped = kind.dropped (scene, like, like);
  run = richest_run (kind, result.scene, result.model);
  if (! isempty (dropped))
    run.x += dropped.x;
    run.y += dropped.y;
  endif
endfunction

%!test # of a rod that needs no modes it is the same motion, by the exact rod and by modes
%! evalc ("result = driver (setfield (swing (), 'duration', 0.1), 'output', '');");
%! assert (result.summary.estimated_error_m > 0);
%! for seconds = [60 0]
%!   evalc ("reference = far_richer (result, seconds);");
%!   assert (isfield (reference, "off"), seconds > 0);
%!   off = distance (result, reference);
%!   assert (off > 0 && off < result.summary.tolerance_m/20);
%! endfor
