## -*- texinfo -*-
## @deftypefn {} {@var{run} =} far_richer (@var{result})
## The scene of a @var{result} of @code{driver} run by a far richer model of the same physics (see
## @code{richest_run}), its points moved by what all such models drop (see
## @code{dropped_error}).
## @end deftypefn

function run = far_richer (result)
  scene = result.scene;
  kind = kind_of (scene);
  run = richest_run (kind, scene, result.model);
  scene.solver.tolerance /= 20;
  dropped = kind.dropped (scene, run, run);
  if (! isempty (dropped))
    run.x += dropped.x;
    run.y += dropped.y;
  endif
endfunction

%!test # of a rod that needs no modes it is the same motion
%! result = driver (setfield (swing (), "duration", 0.2), "output", "");
%! assert (result.summary.estimated_error_m > 0);
%! off = distance (result, far_richer (result));
%! assert (off > 0 && off < result.summary.tolerance_m/20);
