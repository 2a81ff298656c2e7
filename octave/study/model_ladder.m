## -*- texinfo -*-
## @deftypefn {} {@var{table} =} model_ladder (@var{scene}, @var{option}, @var{value}, @dots{})
## The ladder of models of a scene, error against cost: the points of each rung around the one that @code{choose} takes
## against those of a far richer model, or of the geometrically exact rod where that can be had (see
## @code{exact_runs}); its own error is what more polynomials change.  Arguments as for @code{driver}, and
## "budget": the seconds that it may take (60).  Modes are chosen.
##
## Leaves models.csv, models.svg and models.png in the folder of the scene's output.  @var{table} is a struct array of
## model, method, error_m, seconds, calls, label and curve (in the chart), chosen and part.  The rungs are integrated
## as `auto' would; the chosen one, and the paper's 7 + 7 sines, by `ode45' too, where that is a method for the scene:
## what takes too long is extrapolated (see @code{precision_point}), its error no less than `auto' has on the whole.
## @end deftypefn

function table = model_ladder (scene = "paper", varargin)
  [scene, kind, output, left] = study_scene (scene, [varargin, {"modes", "auto"}]);
  refuse_one_frame (scene);
  ladder = ladder_of (kind, scene, left);
  found = measure_all (kind, scene, ladder, left);
  publish_study (output, {"models.csv"}, {"models.svg", "models.png"}, @(aside) write_ladder (found, aside), ...
                 @(scratch) draw_ladder (found, ladder.labels, scene, scratch));
  if (nargout > 0)
    table = found;
  endif
endfunction

function table = measure_all (kind, scene, ladder, left)
  choice = told_choice (ladder, scene.solver.tolerance);
  [richest, rich] = richest_of (kind, scene, ladder, choice, left ()/3);
  reference = richest;
  [exact, converged] = exact_runs (kind, scene, left ()/2);
  if (converged)
    reference = exact;
  endif
  table = rung_rows (kind, scene, ladder, choice, reference, left ()/2);
  reference.times = frame_times (scene);
  reference.off = Inf;  # what models drop does not grow with time as errors of methods do
  for rung = by_ode45 (kind, scene, choice)
    point = ode45_point (kind, scene, rung{1}, reference, left ()/3);
    same = table(strcmp ({table.model}, ladder.name (rung{1})));
    if (point.part < 1)
      point.error_m = max ([point.error_m, same.error_m]);
    endif
    table = [table, setfield(rung_row (ladder, rung{1}, point, point.error_m, choice.rung), "part", point.part)];
    if (! isempty (point.failure))
      say ("    %s", point.failure);
    endif
  endfor
  if (! any (strcmp ({table.model}, ladder.name (rich))))
    table = [table, rung_row(ladder, rich, richest.count, distance (richest, reference), choice.rung)];
  endif
  if (! isempty (exact))
    ladder.name = @(rung) exact.name;
    ladder.label = @(rung) "exact";
    off = distance (exact, richest);
    if (converged)
      off = exact.off;
    endif
    table = [table, rung_row(ladder, choice.rung, exact.count, off, [])];
  endif
endfunction

## the choice's richest where a far richer model takes too long
function [run, rung] = richest_of (kind, scene, ladder, choice, seconds)
  scene.solver.seconds = seconds;
  try
    [run, rung] = richest_run (kind, scene, choice.trial.model);
  catch err
    rethrow_others (err, "toolchain:integration:time");
    run = choice.reference;
    if (ladder.poorer (run.rung, choice.rung))  # the choice gave up
      run = choice.trial;
    endif
    rung = run.rung;
    say ("  a far richer model was %s: the reference is the choice's richest, %s", strtrim (err.message), ...
         ladder.name (rung));
  end_try_catch
endfunction

function rungs = by_ode45 (kind, scene, choice)
  rungs = {};
  if (ismember ("rate", kind.system (scene, choice.trial.model).forms))
    rungs = {choice.rung};
    if (! isempty (kind.literal (scene)))
      rungs{2} = kind.literal (scene);
    endif
  endif
endfunction

function point = ode45_point (kind, scene, rung, reference, limit)
  table = integrator_table ({"rate"});
  ode45 = table(strcmp ({table.name}, "ode45"));
  point = precision_point (kind, scene, kind.build (scene, rung), ode45, scene.solver.tolerance, reference, limit);
  point.method = "ode45";
endfunction

%!error <cannot be made|can be written> model_ladder ("chain(20)", "output", "/proc/nowhere")
%!test # a rigid rod is enough, and the table has it
%! [folder, gone] = scratch_folder ();
%! scene = setfield (setfield (swing (), "duration", 0.002), "frames_per_second", 1000);
%! scene.model.stiffening = "none";
%! evalc ("table = model_ladder (scene, 'output', folder);");
%! assert (table(find ([table.chosen], 1)).model, "rigid");
%! lines = strsplit (strtrim (fileread (fullfile (folder, "models.csv"))), "\n");
%! assert (numel (lines), numel (table) + 1);
%! assert (stat (fullfile (folder, "models.png")).size > 10000);
%!test # ode45 on a part of the time is off by no less than the same model on the whole
%! [folder, gone] = scratch_folder ();
%! scene = setfield (paper (), "duration", 0.9);
%! evalc ("table = model_ladder (scene, 'output', folder, 'pictures', false, 'budget', 40);");
%! ode45 = table(strcmp ({table.method}, "ode45") & [table.chosen]);
%! whole = table([table.chosen] & ! strcmp ({table.method}, "ode45")).error_m;
%! assert (ode45.error_m >= 0.9*whole); assert (ode45.error_m < 3*whole);
%! assert (numel (unique (strcat ({table.model}, {table.method}))), numel (table));
%!test # of every other kind, too: more modes, a smaller error
%! scenes = {setfield(setfield (arc_pendulum (), "duration", 0.05), "solver", "tolerance", 1e-4), ...
%!           setfield(setfield (setfield (chain (1), "duration", 0.01), "frames_per_second", 300), "solver", ...
%!                    "tolerance", 1e-4), ...
%!           setfield(setfield (large_swing (), "duration", 0.02), "solver", "tolerance", 1e-3)};
%! for scene = scenes
%!   [folder, gone] = scratch_folder ();
%!   evalc ("table = model_ladder (scene{1}, 'output', folder, 'pictures', false);");
%!   assert (sum ([table.chosen] & ! strcmp ({table.method}, "ode45")), 1);
%!   assert (table(end-1).error_m > 0 && table(1).error_m >= table([table.chosen])(1).error_m);
%!   assert (exist (fullfile (folder, "models.csv"), "file"), 2);
%! endfor
