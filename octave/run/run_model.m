## -*- texinfo -*-
## @deftypefn {} {@var{run} =} run_model (@var{kind}, @var{scene}, @var{model}, @var{solver}, @var{before}, @var{dense})
## The motion of a checked scene of a @var{kind} (see @code{kind_of}) as a @var{model} has it, by the @var{solver} (a
## struct as scene.solver, which is the default): a struct of
##
## @table @code
## @item model, solver, count, warnings, end_state
## the model, the solver and the count of @code{integrate}, what the system has to say, and its state at the end
## @item history
## what is observed at the frame times: a struct with t, T, U, Z, W, D, balance and energy_floor, and what the kind has
## @item x, y, z
## the points that tell two motions apart (points-by-frames, m; z where they leave the plane; see @code{distance})
## @item between
## the frames' times and some between them, t (1-by-m, s), 4096 or more in all, and the states then, where they are to
## be @var{dense}, or cost the method next to nothing, and there is more than one frame
## @end table
##
## A run @var{before} leads this one (see led_by of a kind). Where it is of the same model the energies are known: work
## and what dissipates are then integrated to a share of what changes. A run that leaves its energy balance is an
## error, but that "auto" tries with less first, three times.
## @end deftypefn

function run = run_model (kind, scene, model, solver = scene.solver, before = [], dense = false)
  system = started_system (kind, scene, model);
  system.frames = frame_times (scene);
  if (! isempty (before))
    system = kind.led_by (system, before);
    system.led_step = @(tolerance) step_within (tolerance, scene.duration, before);
    if (isequal (before.model, model))
      system = with_work (system, before.history, solver.tolerance);
    endif
  endif
  for attempt = 1:4
    times = system.frames;
    fine = numel (times) > 1 && (dense || method_of (system, solver.name).dense);
    if (fine)
      times = finer_times (times, 4096);
    endif
    [states, count] = integrate (system, times, solver);
    at_frames = ismember (times, system.frames);
    run = kind.observe (scene, model, system, system.frames, states(:,at_frames));
    off = max (energy_error (run.history));
    if (! strcmp (solver.name, "auto") || off <= 0.05 || count.still)
      break;
    endif
    solver = kind.tighter (solver, off);
  endfor
  watch_balance (run.history, system, count);
  run.model = model;
  run.solver = solver;
  run.end_state = states(:,end);
  if (fine)
    run.between = struct ("t", times, "states", states);
  endif
  run.count = count;
  run.warnings = system.warnings;
endfunction

## that which such a run takes on the average, made shorter where less is asked for, as an estimate of order 5 says
function h = step_within (tolerance, duration, run)
  h = duration/max (1, run.count.steps)*min (1, tolerance/run.solver.tolerance)^(1/6);
endfunction

## the frames' times, and equally many between two as make so many in all, or some more
function times = finer_times (frames, count)
  each = max (1, ceil (count/numel (frames)));
  times = [(frames(1:end-1) + (0:each-1).'/each.*diff (frames, 1, 2))(:).', frames(end)];
endfunction

## W and D may be off by 1e-6 of what changes, as the integrator estimates it: some tens of times what they are off by
function system = with_work (system, history, tolerance)
  change = max ([range(history.T), range(history.W), range(history.D), history.energy_floor]);
  rows = system.energy_rows;
  system.state_scale(rows) = min (system.state_scale(rows), 1e-6*change/(100*tolerance));
endfunction

%!test # the rigid rod
%! scene = check_scene (setfield (paper (), "model", "modes", [0 0]));
%! model = build_model (scene, rung_of_scene (scene));
%! run = run_model (rod_kind (), scene, model, struct ("name", "ode45", "tolerance", 1e-6));
%! assert (size (run.x), [21 91]); assert (run.count.method, "ode45");
%! assert (hypot (run.x(end,:), run.y(end,:)), ones (1, 91), 1e-12);
%! assert (isfield (run, "between"), false);
%! dense = run_model (rod_kind (), scene, model, struct ("name", "waveform", "tolerance", 1e-6), [], true).between;
%! assert (columns (dense.states), numel (dense.t)); assert (numel (dense.t), 4096, 100);
%! each = (numel (dense.t) - 1)/90;
%! assert (dense.t(1:each:end), run.history.t, 1e-15); assert (dense.states(1,1:each:end), run.history.phi, 1e-5);
%!test # a mechanism keeps its balance, with springs, dampers and a force
%! [system, ~, scene] = sample_mechanism ([0 1]);
%! scene.solver.tolerance = 1e-6; scene.frames_per_second = 20;
%! run = run_model (mechanism_kind (), scene, system.mechanism);
%! assert (energy_error (run.history) < 1e-7);
%! assert (run.history.D(end) > 0 && run.history.W(end) != 0);
%! assert (size (run.start_jacobian), [system.constraint_count, system.n]);
%! assert (size (run.x), [33, numel(run.history.t)]);
%!test # two ways through time of a rod on a surface
%! scene = check_surface_scene (setfield (setfield (large_swing (), "duration", 0.1), "model", "modes", [4 4]));
%! tip = @(name, tolerance) run_model (surface_kind (), scene, surface_rod (scene), ...
%!                                     struct ("name", name, "tolerance", tolerance)).history.tip(:,end);
%! assert (tip ("auto", 1e-9), tip ("lsode_bdf", 1e-7), 1e-6);
%!function [run, asked] = of_balance (off, name, speed)   # runs whose balance is off by so much, one after the other
%!  system = struct ("initial_state", [0; speed; 0; 0], "breaks", [], "state_scale", [1; 1; 1; 1], "duration", 1, ...
%!                   "longest_step", Inf, "mass", 1, "stiffness", 0, "velocity_matrix", 1, "forms", {{"rate"}}, ...
%!                   "auto", "ode45", "warnings", {{"of the system"}}, "rate", @(t, y) [y(2); 0; 0; 0]);
%!  asked = containers.Map ("KeyType", "double", "ValueType", "any");
%!  kind = struct ("system", @(scene, model) system, "tighter", @(solver, off) tightened (solver, off, asked));
%!  kind.observe = @(scene, model, system, times, states) observed (times, off(asked.Count + 1));
%!  scene = struct ("duration", 1, "frames_per_second", 2, "solver", struct ("name", name, "tolerance", 1e-3));
%!  run = run_model (kind, scene, "the model");
%!endfunction
%!function solver = tightened (solver, off, asked)
%!  asked(asked.Count + 1) = [solver.tolerance, off];
%!  solver.tolerance /= 2;
%!endfunction
%!function run = observed (times, off)
%!  none = zeros (size (times));
%!  run = struct ("x", none, "y", none);
%!  run.history = struct ("t", times, "T", linspace (0, 1, numel (times)), "U", none, "Z", none, "W", none, ...
%!                        "D", none, "balance", [none(1:end-1), off], "energy_floor", 0);
%!endfunction
%!test # "auto" tries again, with less, for as long as the balance is off, three times at most
%! [run, asked] = of_balance ([0.2 0.1 0.05], "auto", 1);
%! assert (cell2mat (asked.values ().'), [1e-3 0.2; 5e-4 0.1], 1e-12); assert (max (abs (run.history.balance)), 0.05);
%! assert ({run.model, run.warnings, run.count.method}, {"the model", {"of the system"}, "ode45"});
%! assert (of_balance ([0.2 0.2 0.2 0.01], "auto", 1).history.balance(end), 0.01);
%!error <balance is off by 0.2> of_balance ([0.2 0.2 0.2 0.2 0], "auto", 1)
%!error <balance is off by 0.2> of_balance ([0.2 0], "ode45", 1)
%!test # what stays where it is has no balance to lose
%! [run, asked] = of_balance ([0.2 0.1 0], "auto", 0);
%! assert (asked.Count, uint64 (0));
