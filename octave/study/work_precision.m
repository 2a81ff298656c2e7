## -*- texinfo -*-
## @deftypefn {} {@var{table} =} work_precision (@var{scene}, @var{option}, @var{value}, @dots{})
## The work-precision diagram of all integrators that a scene's equations have a form for: the largest error of all
## points over all frames against seconds (medians) and calls, or, where there are constraints, their drift; and the
## ladder of models and the cost against the number of modes beside them.  Arguments as for @code{driver}, and
## "budget": the seconds that it may take (60).  The model is the scene's, or, where that is to be chosen, the paper's
## 7 + 7 sines, and of other rods what @code{choose} finds.
##
## A fifth of the time is for the reference (see @code{reference_run}), a fifth for ladder and cost, the rest for the
## methods: half of it for a point of each, the other half for more, of the fastest first.  What does not fit is run on
## a part of the duration, and extrapolated (see @code{precision_point}).  The literal equations, the paper's way, have
## the calls of ode45 at the price of a literal call.  Leaves chart.csv, cost.csv (see @code{cost_of_size}), chart.md
## (see @code{chart_words}), chart.svg and chart.png; @var{table} is a struct array of rows of @code{precision_point}.
## @end deftypefn

function table = work_precision (scene = "paper", varargin)
  [scene, kind, output, left] = study_scene (scene, varargin);
  refuse_one_frame (scene);
  budget = left ();
  [rung, choice, ladder] = charted (kind, scene, left);
  model = kind.build (scene, rung);
  system = started_system (kind, scene, model);
  reference = reference_run (kind, scene, model, min (budget/5, left ()/3));
  say ("  reference: %s at %g m, within %.1g m of a hundred times that", reference.name, reference.tolerance, ...
       reference.off);
  rungs = struct ([]);
  if (! isempty (choice))
    estimate = estimate_error (kind, scene, choice.trial, choice.reference);
    choice.error_m = estimate.metres;
    rungs = rung_rows (kind, scene, ladder, choice, estimate.rod, min (budget/10, left ()/4));
  endif
  cost = cost_of_size (kind, scene, 2.^(1:6), min (budget/10, left ()/4));
  found = method_curves (kind, scene, model, system, reference, @() left () - min (3, budget/10));
  if (isequal (rung, kind.literal (scene)))
    found = [found, literal_rows(found)];
  endif
  notes = struct ("title", scene.title, "tolerance", scene.solver.tolerance, "floor", reference.off/10, ...
                  "auto", system.auto);
  words = chart_words (found, notes.auto, notes.tolerance, choice, notes.floor);
  say ("%s", words);
  publish_study (output, {"chart.csv", "cost.csv", "chart.md"}, {"chart.svg", "chart.png"}, ...
                 @(aside) write_chart (found, cost, scene.title, words, aside), ...
                 @(scratch) draw_chart (found, rungs, cost, notes, scratch));
  if (nargout > 0)
    table = found;
  endif
endfunction

## the rung whose model is charted, and where it was to be chosen, the choice and its ladder
function [rung, choice, ladder] = charted (kind, scene, left)
  rung = known_rung (kind, scene);
  choice = ladder = [];
  if (isempty (rung))
    ladder = ladder_of (kind, scene, left);
    choice = told_choice (ladder, scene.solver.tolerance);
    rung = choice.rung;
    if (! isempty (kind.literal (scene)))
      rung = kind.literal (scene);
    endif
  endif
endfunction

## the calls of ode45 on the same equations, at the price of a literal call
function rows = literal_rows (table)
  rows = table(strcmp ({table.method}, "ode45"));
  seconds = call_times ();
  for k = 1:numel (rows)
    rows(k).method = "literal ode45";
    rows(k).seconds *= seconds(2)/seconds(1);
    rows(k).part = 0;  # none of it was run
  endfor
endfunction

%!error <model.modes is "many": it takes> work_precision ("paper", "modes", "many")
%!error <cannot be made|can be written> work_precision ("double_pendulum", "output", "/proc/nowhere")

%!function [csv, words] = short_chart (scene, methods)   # of few methods, with stand-ins for what is timed beside
%!  few = ["{\"" strjoin(methods, "\", \"") "\"}"];
%!  stand_ins = {
%!    "rows = cost_of_size", "kind, scene, sizes, limit", "rows = sizes(:)*[1 2 3];"
%!    "seconds = call_times", "", "seconds = [1 70];"
%!    "table = usable_methods", "table", ["table = table(ismember ({table.name}, " few "));"]};
%!  folder = tempname (); confirm_recursive_rmdir (false, "local");
%!  unwind_protect
%!    evalc ("with_stand_ins (stand_ins, @() work_precision (scene, 'output', folder, 'budget', 12));");
%!    csv = fileread (fullfile (folder, "chart.csv"));
%!    words = fileread (fullfile (folder, "chart.md"));
%!    assert (csvread (fullfile (folder, "cost.csv"), 1, 0)(:,1:3), 2.^(1:6).'*[1 2 3]);
%!    assert (stat (fullfile (folder, "chart.png")).size > 10000);
%!  unwind_protect_cleanup
%!    rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!function values = of (csv, name, k)
%!  lines = strsplit (strtrim (csv), "\n")(2:end);
%!  lines = lines(strncmp (lines, [name ","], numel (name) + 1));
%!  values = cellfun (@(line) str2double (strsplit (line, ","){k}), lines);
%!endfunction
%!test # errors within tolerances, or of stable steps; literal calls cost 70 times ode45's
%! scene = setfield (setfield (paper (), "duration", 0.002), "frames_per_second", 2000);
%! csv = short_chart (scene, {"waveform", "exponential", "ode45", "rk4"});
%! for name = {"waveform", "exponential", "ode45"}
%!   assert (diff (of (csv, name{1}, 2)) < 0); assert (numel (of (csv, name{1}, 2)) >= 2);
%!   assert (of (csv, name{1}, 3) <= max (of (csv, name{1}, 2), 1e-10));
%! endfor
%! steps = of (csv, "rk4", 2);
%! stable = steps*2.0447e5 < 2.828;  # the highest frequency of 7 + 7 sines
%! ran = isfinite (of (csv, "rk4", 3));  # and not given up
%! assert (any (ran)); assert (stable(ran)); assert (of (csv, "rk4", 3)(ran) < 1e-6);
%! calls = of (csv, "rk4", 6)(ran).*steps(ran)/(4*0.002);  # of a part some more: it ends at more times
%! assert (calls > 0.95 & calls < 2);
%! assert (of (csv, "literal ode45", 3), of (csv, "ode45", 3));
%! assert (of (csv, "literal ode45", 5), 70*of (csv, "ode45", 5), 1e-9);
%!test # of a mechanism and of a rod on a surface: errors within tolerances
%! scenes = {setfield(setfield (chain (1), "duration", 0.01), "frames_per_second", 300), {"radau", "projection"}
%!           setfield(setfield (setfield (large_swing (), "duration", 0.02), "frames_per_second", 100), "model", "modes", ...
%!                    [4 4]), {"gauss", "lsode_adams"}};
%! for row = scenes.'
%!   csv = short_chart (row{:});
%!   for name = row{2}
%!     tolerances = of (csv, name{1}, 2);
%!     errors = of (csv, name{1}, 3);
%!     assert (errors <= 2*max (tolerances, 1e-9));
%!   endfor
%! endfor
%!test # the model's error is that against the rod, with what all models drop: of an arc ten times what its family shows
%! scene = setfield (setfield (arc_pendulum (), "duration", 0.4), "frames_per_second", 20);
%! [~, words] = short_chart (scene, {"waveform"});
%! evalc ("summary = driver (scene, 'exact', false, 'output', '').summary;");
%! said = str2double (regexp (words, 'off by (\S+) m, \d+ % of the tolerance', "tokens", "once"){1});
%! assert (said, summary.estimated_error_m, -0.1);
%! assert (said > 4*summary.tried([summary.tried.chosen]).error_m);
