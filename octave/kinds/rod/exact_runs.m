## -*- texinfo -*-
## @deftypefn {} {[@var{run}, @var{converged}] =} exact_runs (@var{kind}, @var{scene}, @var{seconds})
## The geometrically exact rod of a checked scene of a @var{kind} (see @code{kind_of} and @code{exact_rod}) with 12 +
## 12 polynomials, with a name, how far 9 + 9 polynomials are off it (off, m), and whether it has converged: by a fifth
## of the tolerance at most.  Empty and false where it has not what the scene has, or takes longer than @var{seconds},
## which is said.
## @end deftypefn

function [run, converged] = exact_runs (kind, scene, seconds)
  run = [];
  start = tic ();
  converged = false;
  if (isempty (kind.exactly (scene)))
    return;
  endif
  try
    run = exact_rod (scene, 12, 2/3*seconds);
    run.name = "geometrically exact, 12 + 12 polynomials";
    run.off = distance (run, exact_rod (scene, 9, seconds - toc (start)));
    converged = run.off <= scene.solver.tolerance/5;
    printf ("  the exact rod with 9 + 9 and with 12 + 12 polynomials: %.2g m apart\n", run.off);
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
    printf ("  the exact rod is no reference: %s\n", strtrim (err.message));
  end_try_catch
endfunction

%!test # none of a curved rod
%! [run, converged] = exact_runs (rod_kind (), check_scene (hook ()), 60);
%! assert (run, []); assert (! converged);
%!test # of a stiff rod that swings it has converged
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "model", "modes", [0 0]));
%! evalc ("[run, converged] = exact_runs (rod_kind (), scene, 60);");
%! assert (converged); assert (run.off <= scene.solver.tolerance/5); assert (columns (run.x), numel (frame_times (scene)));
