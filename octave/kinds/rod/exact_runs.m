## -*- texinfo -*-
## @deftypefn {} {[@var{run}, @var{converged}] =} exact_runs (@var{kind}, @var{scene}, @var{seconds}, @var{near})
## The geometrically exact rod of a checked scene of a @var{kind} (see @code{kind_of} and @code{exact_rod}) with 12 +
## 12 polynomials, or more, up to 32, each time with a quarter of the tolerance, until it has @var{converged}: with a
## name, and how far the one before is off it (off, m), @var{near} (run) at most (by default a fifth of the tolerance).
## The last that was run, and false, where they take longer than so many @var{seconds}; empty where it has not what the
## scene has, or the first two take longer, which is said.
## @end deftypefn

function [run, converged] = exact_runs (kind, scene, seconds, near = @(run) scene.solver.tolerance/5)
  run = [];
  start = tic ();
  converged = false;
  if (isempty (kind.exactly (scene)))
    return;
  endif
  try
    fewer = exact_rod (scene, 9, seconds/3);
    finer = scene;
    for modes = [12 16 20 25 32]
      finer.solver.tolerance /= 4;
      richer = exact_rod (finer, modes, seconds - toc (start), fewer);
      richer.name = sprintf ("geometrically exact, %d + %d polynomials", modes, modes);
      richer.off = distance (richer, fewer);
      converged = richer.off <= near (richer);
      run = fewer = richer;
      printf ("  the exact rod with %d + %d polynomials, and one with fewer: %.2g m apart\n", modes, modes, run.off);
      if (converged)
        break;
      endif
    endfor
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
    if (isempty (run))
      printf ("  the exact rod is no reference: %s\n", strtrim (err.message));
    endif
  end_try_catch
endfunction

%!test # none of a rod so thick that it has not that
%! [run, converged] = exact_runs (rod_kind (), check_scene (setfield (hook (), "rod", "half_height", 0.01)), 60);
%! assert (run, []); assert (! converged);
%!test # of a stiff rod that swings it has converged
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "model", "modes", [0 0]));
%! evalc ("[run, converged] = exact_runs (rod_kind (), scene, 60);");
%! assert (converged); assert (run.off <= scene.solver.tolerance/5); assert (columns (run.x), numel (frame_times (scene)));
