## -*- texinfo -*-
## @deftypefn {} {@var{table} =} work_precision (@var{scene}, @var{option}, @var{value}, @dots{})
## The work-precision diagram of all integrators on a scene (of several bodies: see @code{constrained_precision}) with
## the paper's sines (7 + 7 without the option "modes"): the errors of tip and hinge angle over all frames against
## seconds (medians) and calls of the rate, and the ladder of models and the cost against the number of modes beside
## them. Arguments as for @code{driver}.
##
## The reference is `waveform' at 1e-10 m, and `exponential' has to agree with it to 1e-10.  What would take more than
## 20 s (but for ode45 at 1e-6 m) is run on a part of the duration, with its error there: extrapolated; what then takes
## ten times as long is given up.  The literal equations, the paper's way, have the calls of ode45 at the price of a
## literal call.  Leaves chart.csv, cost.csv (of @code{cost_of_size}), chart.svg and chart.png; @var{table} is a struct
## array of method, parameter (tolerance in m, or step in s), tip_error, phi_error (m, rad), seconds, calls,
## extrapolated, failure.
## @end deftypefn

function table = work_precision (scene = "paper", varargin)
  [scene, name] = load_scene (scene);
  [scene, output] = take_options (scene, fullfile ("output", name), varargin);
  measure_all = @precision_of_rod;
  if (isfield (scene, "bodies"))
    measure_all = @constrained_precision;
  endif
  [found, write, draw] = measure_all (scene, output.folder);
  publish_study (output, {"chart.csv", "cost.csv"}, {"chart.svg", "chart.png"}, write, draw);
  if (nargout > 0)
    table = found;
  endif
endfunction

## the table, and what writes it into a folder and draws it
function [table, write, draw] = precision_of_rod (scene, folder)
  scene = check_scene (scene);
  require_folder (folder);
  ladder = ladder_of (scene);
  if (ischar (scene.model.modes))
    scene.model.modes = [7 7];
  endif
  model = build_model (scene, rung_of_scene (scene));
  system = rod_system (scene, model);
  reference = reference_run (scene, model, system);

  cost = cost_of_size (2.^(1:6));
  table = struct ([]);
  whole = @(method, parameter) strcmp (method.name, "ode45") && parameter == 1e-6;  # what all others are measured by
  for method = usable_methods (integrator_table ())
    parameters = 10.^(-2:-1:-9);
    if (! method.adaptive)
      parameters = 10.^(-2:-0.5:-6);
    endif
    for parameter = parameters
      row = precision_point (scene, model, system, method, parameter, reference, 20/(1 - whole (method, parameter)));
      table = [table, row];
      report (row);
      if (strncmp (row.failure, "given up", 8) || (row.extrapolated && parameter < 2e-6))
        break;
      endif
    endfor
  endfor
  table = [table, literal_rows(scene, table)];
  write = @(aside) write_chart (table, cost, aside);
  draw = @(scratch) draw_chart (table, ladder, cost, scene, scratch);
endfunction

function reference = reference_run (scene, model, system)
  times = frame_times (scene);
  states = @(name, tolerance) integrate (system, times, struct ("name", name, "tolerance", tolerance));
  at = @(name, tolerance) measure (system, model, times, states (name, tolerance));
  [reference, other] = deal (at ("waveform", 1e-10), at ("exponential", 2e-11));
  [tip, phi] = precision_errors (other, reference);
  printf ("  reference: waveform and exponential differ by %.2g m and %.2g rad\n", tip, phi);
  if (max (tip, phi) > 1e-10)
    printf ("warning: the reference is good to %.1g only\n", max (tip, phi));
  endif
endfunction

## the calls of ode45 on the same equations, at the price of a literal call
function rows = literal_rows (scene, table)
  rows = table(strcmp ({table.method}, "ode45"));
  if (! isequal (scene.model.modes(:).', [7 7]) || isempty (rows))
    rows = rows([]);
    return;
  endif
  seconds = call_times ();
  for k = 1:numel (rows)
    rows(k).method = "literal ode45";
    rows(k).seconds *= seconds(2)/seconds(1);
    rows(k).extrapolated = true;
  endfor
endfunction

function report (row)
  printf ("  %-18s %-7.2g tip %8.2g m, phi %8.2g rad, %8.2f s, %9d calls%s %s\n", row.method, row.parameter, ...
          row.tip_error, row.phi_error, row.seconds, row.calls, {"", " (extrapolated)"}{1 + row.extrapolated}, ...
          row.failure);
  fflush (stdout);
endfunction

function rows = ladder_of (scene)
  choice = choose (rod_ladder (scene), scene.solver.tolerance);
  rows = struct ([]);
  for rung = ladder_rungs (choice.trial.rung, choice.reference.rung)
    trial = trial_run (scene, rung{1});
    rows = [rows, struct("label", rung_label (rung{1}), "error_m", distance (trial, choice.reference), ...
                         "seconds", trial.seconds, "chosen", isequal (rung{1}, choice.trial.rung))];
  endfor
endfunction

%!error <model.modes is "many": it takes> work_precision ("paper", "modes", "many")
%!error <cannot be made|can be written> work_precision ("paper", "output", "/proc/nowhere")
%!error <cannot be made|can be written> work_precision ("double_pendulum", "output", "/proc/nowhere")

%!function csv = short_chart ()   # of 2 ms, three methods, and stand-ins for what is timed beside
%!  scene = paper ();
%!  [scene.duration, scene.frames_per_second] = deal (0.002, 2000);
%!  stand_ins = {
%!    "rows = cost_of_size", "sizes", "rows = sizes(:)*[1 2 3];"
%!    "seconds = call_times", "", "seconds = [1 70];"
%!    "table = integrator_table", "", [ ...
%!      "table = struct (\"name\", {\"waveform\", \"exponential\", \"ode45\", \"rk4\"}, \"run\"," ...
%!      " {@integrate_waveform, @integrate_exponential, @(varargin) integrate_explicit(@ode45, varargin{:})," ...
%!      " @(varargin) integrate_fixed(@rk4, 4, varargin{:})}, \"adaptive\", {true, true, true, false});"]};
%!  folder = tempname (); confirm_recursive_rmdir (false, "local");
%!  unwind_protect
%!    evalc ("with_stand_ins (stand_ins, @() work_precision (scene, 'output', folder));");
%!    csv = fileread (fullfile (folder, "chart.csv"));
%!    assert (csvread (fullfile (folder, "cost.csv"), 1, 0)(:,1:3), 2.^(1:6).'*[1 2 3]);
%!  unwind_protect_cleanup
%!    rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!test # a row each tolerance or step: its error within it; literal calls cost 70 times ode45's
%! lines = strsplit (strtrim (short_chart ()), "\n")(2:end);
%! rows_of = @(name) lines(strncmp (lines, [name ","], numel (name) + 1));
%! of = @(name, k) cellfun (@(line) str2double (strsplit (line, ","){k}), rows_of (name));
%! for name = {"waveform", "exponential", "ode45"}
%!   assert (of (name{1}, 2), 10.^(-2:-1:-9), 1e-12);
%!   assert (of (name{1}, 3) <= max (of (name{1}, 2), 1e-10));
%! endfor
%! steps = of ("rk4", 2);
%! assert (steps, 10.^(-2:-0.5:-6), 1e-12);
%! stable = steps*2.0447e5 < 2.828;  # the highest frequency of 7 + 7 sines
%! assert (of ("rk4", 3) < 1e-6, stable);
%! assert (of ("rk4", 6)(stable), 4*0.002./steps(stable), -0.02);
%! assert (of ("literal ode45", 3), of ("ode45", 3)); assert (of ("literal ode45", 5), 70*of ("ode45", 5), 1e-9);
