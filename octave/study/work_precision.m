## -*- texinfo -*-
## @deftypefn {} {@var{table} =} work_precision (@var{scene}, @var{option}, @var{value}, @dots{})
## The work-precision diagram of all integrators that a scene's equations have a form for: the largest error of all
## points over all frames against seconds (medians) and calls, or, where there are constraints, their drift; and the
## ladder of models and the cost against the number of modes beside them.  Arguments as for @code{driver}; the model is the
## scene's, or, where that is to be chosen, the paper's 7 + 7 sines, and of other rods what @code{choose} finds.
##
## The reference is the first of the kind's (see @code{kind_of}), with which the second is compared.  What would take more
## than 20 s (but for ode45 at 1e-6 m) is run on a part of the duration, with its error there: extrapolated; what then
## takes ten times as long is given up.  The literal equations, the paper's way, have the calls of ode45 at the price of a
## literal call.  Leaves chart.csv, cost.csv (see @code{cost_of_size}), chart.svg and chart.png; @var{table} is a struct
## array of rows of @code{precision_point}.
## @end deftypefn

function table = work_precision (scene = "paper", varargin)
  [scene, kind, output] = study_scene (scene, varargin);
  [rung, ladder] = charted (kind, scene);
  model = kind.build (scene, rung);
  cost = cost_of_size (kind, scene, 2.^(1:6));
  found = measure_all (kind, scene, model, reference_run (kind, scene, model));
  if (isequal (rung, kind.literal (scene)))
    found = [found, literal_rows(found)];
  endif
  publish_study (output, {"chart.csv", "cost.csv"}, {"chart.svg", "chart.png"}, ...
                 @(aside) write_chart (found, cost, aside), @(scratch) draw_chart (found, ladder, cost, scene, scratch));
  if (nargout > 0)
    table = found;
  endif
endfunction

## the rung whose model is charted, and the ladder of models around the chosen one
function [rung, rows] = charted (kind, scene)
  rung = kind.stated (scene);
  rows = struct ([]);
  if (isempty (rung))
    ladder = ladder_of (kind, scene);
    choice = choose (ladder, scene.solver.tolerance);
    rows = rung_rows (kind, scene, ladder, choice, choice.reference);
    rung = choice.rung;
    if (! isempty (kind.literal (scene)))
      rung = kind.literal (scene);
    endif
  endif
endfunction

function run = reference_run (kind, scene, model)
  by = @(name, tolerance) run_model (kind, scene, model, ...
                                     setfield (setfield (scene.solver, "name", name), "tolerance", tolerance));
  run = by (kind.references{1,:});
  if (lacks_sundials (kind.references{2,1}))
    printf ("  reference: %s at %g m\n", kind.references{1,:});
    return;
  endif
  try
    off = distance (run, by (kind.references{2,:}));
  catch err
    if (! strcmp (err.identifier, "toolchain:integration"))
      rethrow (err);
    endif
    off = NaN;
    printf ("  %s\n", strtrim (err.message));
  end_try_catch
  printf ("  reference: %s at %g m, %s at %g m differs from it by %.2g m\n", kind.references.'{:}, off);
endfunction

function table = measure_all (kind, scene, model, reference)
  table = struct ([]);
  for method = usable_methods (integrator_table (kind.system (scene, model).forms))
    parameters = 10.^(-2:-1:-9);
    if (! method.adaptive)
      parameters = 10.^(-2:-0.5:-6)*scene.duration;
    endif
    for parameter = parameters
      budget = 20;
      if (strcmp (method.name, "ode45") && parameter == 1e-6)
        budget = Inf;  # what all others are measured by
      endif
      row = precision_point (kind, scene, model, method, parameter, reference, budget);
      table = [table, row];
      report (row);
      enough = ! method.adaptive && row.error_m < 1e-10;
      if (enough || row.seconds > 1000 || strncmp (row.failure, "given up", 8))
        break;
      endif
    endfor
  endfor
endfunction

## the calls of ode45 on the same equations, at the price of a literal call
function rows = literal_rows (table)
  rows = table(strcmp ({table.method}, "ode45"));
  seconds = call_times ();
  for k = 1:numel (rows)
    rows(k).method = "literal ode45";
    rows(k).seconds *= seconds(2)/seconds(1);
    rows(k).extrapolated = true;
  endfor
endfunction

function report (row)
  note = row.failure;
  if (row.extrapolated)
    note = ["(extrapolated) " note];
  endif
  printf ("  %-18s %-7.2g %8.2g m, %8.2f s, %9d calls %s\n", row.method, row.parameter, row.error_m, row.seconds, ...
          row.calls, note);
  fflush (stdout);
endfunction

%!error <model.modes is "many": it takes> work_precision ("paper", "modes", "many")
%!error <cannot be made|can be written> work_precision ("double_pendulum", "output", "/proc/nowhere")

%!function csv = short_chart (scene, methods)   # of few methods, with stand-ins for what is timed beside
%!  few = ["{\"" strjoin(methods, "\", \"") "\"}"];
%!  stand_ins = {
%!    "rows = cost_of_size", "kind, scene, sizes", "rows = sizes(:)*[1 2 3];"
%!    "seconds = call_times", "", "seconds = [1 70];"
%!    "table = usable_methods", "table", ["table = table(ismember ({table.name}, " few "));"]};
%!  folder = tempname (); confirm_recursive_rmdir (false, "local");
%!  unwind_protect
%!    evalc ("with_stand_ins (stand_ins, @() work_precision (scene, 'output', folder));");
%!    csv = fileread (fullfile (folder, "chart.csv"));
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
%!test # a row each tolerance or step: its error within it; literal calls cost 70 times ode45's
%! scene = setfield (setfield (paper (), "duration", 0.002), "frames_per_second", 2000);
%! csv = short_chart (scene, {"waveform", "exponential", "ode45", "rk4"});
%! for name = {"waveform", "exponential", "ode45"}
%!   assert (of (csv, name{1}, 2), 10.^(-2:-1:-9), 1e-12);
%!   assert (of (csv, name{1}, 3) <= max (of (csv, name{1}, 2), 1e-10));
%! endfor
%! steps = of (csv, "rk4", 2);
%! assert (steps, 0.002*10.^(-2:-0.5:-2.5), 1e-12);  # then it has ten digits
%! stable = steps*2.0447e5 < 2.828;  # the highest frequency of 7 + 7 sines
%! assert (of (csv, "rk4", 3) < 1e-6, stable);
%! assert (of (csv, "rk4", 6)(stable), 4*0.002./steps(stable), -0.02);
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
%!     assert (errors(end) <= 1e-8); assert (errors <= 2*max (tolerances, 1e-9));
%!   endfor
%! endfor
