## -*- texinfo -*-
## @deftypefn {} {[@var{run}, @var{converged}] =} exact_runs (@var{kind}, @var{scene}, @var{seconds}, @var{near})
## The geometrically exact rods of a checked scene of a @var{kind} (see exactly in @code{kind_of}) with 9 polynomials,
## 12 or more, up to 32, each time with a quarter of the tolerance, until they have @var{converged}: a run with a name,
## and how far the one before is off it (off, m), @var{near} (run) at most (by default a fifth of the tolerance).  The
## last that was run, and false, where they take longer than so many @var{seconds}; empty where there are none for the
## scene, or the first two take longer, which is said.
## @end deftypefn

function [run, converged] = exact_runs (kind, scene, seconds, near = @(run) scene.solver.tolerance/5)
  run = [];
  converged = false;
  exact = kind.exactly (scene);
  if (isempty (exact))
    return;
  endif
  kind = kind.of_exact (exact);
  start = tic ();
  tolerance = exact.solver.tolerance/2;
  try
    fewer = of_size (kind, exact, 9, tolerance, seconds/3, []);
    for n = [12 16 20 25 32]
      tolerance /= 4;
      run = of_size (kind, exact, n, tolerance, seconds - toc (start), fewer);
      run.name = sprintf ("geometrically exact, %d polynomials", n);
      run.off = distance (run, fewer);
      converged = run.off <= near (run);
      fewer = run;
      say ("  the exact rod with %d polynomials, and one with fewer: %.2g m apart", n, run.off);
      if (converged)
        break;
      endif
    endfor
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
    if (isempty (run))
      say ("  the exact rod is no reference: %s", strtrim (err.message));
    endif
  end_try_catch
endfunction

function run = of_size (kind, exact, n, tolerance, seconds, before)
  solver = exact.solver;
  [solver.name, solver.tolerance, solver.seconds] = deal ("auto", tolerance, seconds);
  run = run_model (kind, exact, kind.sized (exact, n), solver, before);
endfunction

%!test # none of a rod so thick that it has not that
%! [run, converged] = exact_runs (curved_kind (), check_scene (setfield (hook (), "rod", "half_height", 0.01)), 60);
%! assert (run, []); assert (! converged);
%!test # of a stiff rod that swings it has converged
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "model", "modes", [0 0]));
%! evalc ("[run, converged] = exact_runs (rod_kind (), scene, 60);");
%! assert (converged); assert (run.off <= scene.solver.tolerance/5); assert (columns (run.x), numel (frame_times (scene)));
%!test # and of bodies
%! scene = check_mechanism (setfield (chain (2), "duration", 0.02));
%! evalc ("[run, converged] = exact_runs (mechanism_kind (), scene, 60);");
%! assert (converged); assert (rows (run.x), 22);
