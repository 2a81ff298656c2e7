## -*- texinfo -*-
## @deftypefn {} {@var{table} =} model_ladder (@var{scene}, @var{option}, @var{value}, @dots{})
## The ladder of models of a scene, error against cost: each rung's centreline against that of the geometrically exact
## rod (see @code{exact_rod}), or, where that has not what the scene has, takes too long or has not converged
## (with 9 polynomials it is more than a fifth of the tolerance away), of 30 bending + 30 longitudinal modes with
## foreshortening; the error of the exact rod itself is its distance from these.  Arguments as for @code{driver}.
##
## Leaves models.csv, models.svg and models.png in the folder of the scene's output.  @var{table} is a struct array of
## model, method, error_m, seconds, calls, label (in the chart), stiffening, chosen and extrapolated.  The rungs are
## integrated as `auto' would, the chosen one by `ode45' too, and so are the paper's 7 + 7 sines, as they are: where
## that would take more than 4 million calls, the seconds are extrapolated from a part of the duration, and there is no
## error. Mechanisms and curved rods have a ladder of numbers of modes, see @code{convergence_ladder}.
## @end deftypefn

function table = model_ladder (scene = "paper", varargin)
  [scene, name] = load_scene (scene);
  [scene, output] = take_options (scene, fullfile ("output", name), varargin);
  ladder = @ladder_of_rungs;
  if (isfield (scene, "bodies") || (isfield (scene, "rod") && isfield (scene.rod, "curvature")))
    ladder = @convergence_ladder;
  endif
  [found, scene] = ladder (scene, output.folder);
  publish_study (output, {"models.csv"}, {"models.svg", "models.png"}, @(aside) write_ladder (found, aside), ...
                 @(scratch) draw_ladder (found, scene, scratch));
  if (nargout > 0)
    table = found;
  endif
endfunction

function [table, scene] = ladder_of_rungs (scene, folder)
  scene = check_scene (scene);
  require_folder (folder);
  choice = choose (rod_ladder (scene), scene.solver.tolerance);
  rich = struct ("sines", [], "bending", 30, "longitudinal", 30, "axial", "dynamic", "stiffening", "foreshortening");
  richest = reference = trial_run (setfield (scene, "solver", "tolerance", scene.solver.tolerance/50), rich);
  [exact, converged] = exact_runs (scene);
  if (converged)
    reference = exact;
  endif

  table = struct ([]);
  chosen = choice.trial.rung;
  for rung = ladder_rungs (chosen, choice.reference.rung)
    trial = trial_run (scene, rung{1});
    table = add (table, row_of (trial.rung, trial.count, distance (trial, reference), chosen));
  endfor
  sines = struct ("sines", [7 7], "bending", 7, "longitudinal", 7, ...
                  "axial", "dynamic", "stiffening", chosen.stiffening);
  for rung = {chosen, sines}
    table = add (table, run_ode45 (scene, rung{1}, reference, chosen));
  endfor
  table = add (table, row_of (rich, richest.count, distance (richest, reference), chosen));
  if (! isempty (exact))
    row = row_of (chosen, exact.count, distance (exact, richest), []);
    [row.model, row.label] = deal ("geometrically exact, 12 + 12 polynomials", "exact");
    table = add (table, row);
  endif
endfunction

## with 12 + 12 polynomials, and whether 9 + 9 are near it
function [exact, converged] = exact_runs (scene)
  [exact, converged] = deal ([], false);
  try
    exact = exact_rod (scene, 12);
    if (! isempty (exact))
      off = distance (exact, exact_rod (scene, 9));
      converged = off <= scene.solver.tolerance/5;
      printf ("  the exact rod with 9 + 9 and with 12 + 12 polynomials: %.2g m apart\n", off);
    endif
  catch err
    if (! strcmp (err.identifier, "toolchain:integration"))
      rethrow (err);
    endif
    printf ("  the exact rod is no reference: %s\n", strtrim (err.message));
  end_try_catch
endfunction

function row = run_ode45 (scene, rung, reference, chosen)
  model = build_model (scene, rung);
  system = rod_system (scene, model);
  times = frame_times (scene);
  expected = 0;
  if (! system.turned)
    expected = 2*highest_frequency (system)*times(end);  # 6 calls a step of 3/omega, the limit of stability
  endif
  extrapolated = expected > 4e6;
  if (extrapolated)
    times = times(end)*[0, min(1, 2e5/expected)];
  endif
  tolerance = scene.solver.tolerance/(1 + 3*system.turned);
  [states, count] = integrate (system, times, struct ("name", "ode45", "tolerance", tolerance));
  if (extrapolated)
    factor = scene.duration/times(end);
    [count.seconds, count.calls] = deal (count.seconds*factor, round (count.calls*factor));
    row = setfield (row_of (rung, count, NaN, chosen), "extrapolated", true);
  else
    [moved.x, moved.y] = centreline (model, linspace (0, model.length, 21), measure (system, model, times, states), 1);
    row = row_of (rung, count, distance (moved, reference), chosen);
  endif
endfunction

function row = row_of (rung, count, error_m, chosen)
  row = struct ("model", rung_name (rung), "method", count.method, "error_m", error_m, "seconds", count.seconds, ...
                "calls", count.calls, "label", rung_label (rung), "stiffening", rung.stiffening, ...
                "chosen", isequal (rung, chosen), "extrapolated", false);
endfunction

function table = add (table, row)
  table = [table, row];
  printf ("  %-62s %-11s %8.2g m %8.2f s %8d calls%s\n", row.model, row.method, row.error_m, row.seconds, ...
          row.calls, {"", " <-"}{1 + row.chosen});
endfunction

%!error <cannot be made|can be written> model_ladder ("paper", "output", "/proc/nowhere")
%!error <cannot be made|can be written> model_ladder ("chain(20)", "output", "/proc/nowhere")
%!error <cannot be made|can be written> model_ladder ("hook", "output", "/proc/nowhere")
%!test # a rigid rod is enough, and the table has it
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   scene = setfield (setfield (swing (), "duration", 0.1), "model", "stiffening", "none");
%!   evalc ("table = model_ladder (scene, 'output', folder);");
%!   assert (table(find ([table.chosen], 1)).model, "rigid");
%!   lines = strsplit (strtrim (fileread (fullfile (folder, "models.csv"))), "\n");
%!   assert (numel (lines), numel (table) + 1);
%!   assert (stat (fullfile (folder, "models.png")).size > 10000);
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
