## -*- texinfo -*-
## @deftypefn {} {@var{table} =} scene_stability (@var{scene}, @var{option}, @var{value}, @dots{})
## Where explicit methods turn unstable on a scene's own equations: the limit of step times highest frequency about the
## scene's start (see @code{highest_mode}) and the step that follows, and where the amplitude grows by a hundredth in a
## step, predicted by the method's stability function and measured on the nonlinear equations (of a mechanism: those of
## its accelerations); the largest mean step of adaptive methods; and the limits of the model itself (see
## @code{model_limits}) and of a mechanism's constraints (see @code{constraint_limits}).  Arguments as for
## @code{driver}; the model is what a run would take.
##
## Leaves stability.csv, stability.svg and stability.png in the folder of the scene's output.  @var{table} is a struct
## array of method, what, predicted and measured, as from @code{stability}.
## @end deftypefn

function table = scene_stability (scene = "paper", varargin)
  given = scene;
  [scene, kind, output, left] = study_scene (scene, varargin);
  refuse_one_frame (scene);
  [model, choice] = chosen_model (kind, scene);
  whole = kind.system (scene, model);
  system = at_rates (whole);
  mode = struct ("omega", 0);
  if (rows (system.mass) > 0)
    mode = highest_mode (system);
  endif
  if (mode.omega == 0)
    scene_error ("nothing oscillates: stability takes a model that bends, MODES=\"0 2\" say");
  endif
  say ("  highest frequency about the start: %.6g rad/s", mode.omega);
  found = [told(load_limits (given, varargin, left)), told(model_limits (kind, scene, model, choice.trial, left))];
  if (ismember ("constrained", whole.forms) && whole.constraint_count > 0)
    found = [found, told(constraint_limits (whole, scene.solver, min (scene.duration, 100/mode.omega)))];
  endif
  curves = {};
  exact = true_amplitudes (system, mode);
  for method = explicit_methods (system)
    [rows, curve] = limits_of (system, mode, method{1}, exact);
    found = [found, rows];
    curves{end+1} = struct ("method", method{1}, "limit", rows(2).predicted, "points", curve);
  endfor
  publish_study (output, {"stability.csv"}, {"stability.svg", "stability.png"}, ...
                 @(aside) write_stability (found, aside), ...
                 @(scratch) draw_limits (curves, scene.title, mode.omega, scratch));
  if (nargout > 0)
    table = found;
  endif
endfunction

## the system with rates; steps are those that are asked for
function system = at_rates (system)
  if (! ismember ("rate", system.forms))
    ode = state_space (system);
    start = named_rows (system, system.initial_state);
    ode.initial_state = ode.pack (start);
    ode.forms = {"rate"};
    ode.breaks = system.breaks;
    system = ode;
  endif
  system.turned = false;
endfunction

function names = explicit_methods (system)
  table = integrator_table (system.forms);
  limited = isfinite (cellfun (@stability_limit, {table.name}));
  names = {table(limited).name};
endfunction

## limit and growth beyond it, and growth at some steps: rows of h omega, predicted and measured
function [rows, curve] = limits_of (system, mode, name, exact)
  limit = stability_limit (name);
  beyond = fzero (@(h_omega) predicted_growth (name, h_omega) - 1.01, limit*[1 2]);
  growth = @(h_omega) measured_growth (system, mode, name, h_omega, exact);
  measured = measured_limit (@(h_omega) growth (h_omega) <= 1.01, beyond);
  curve = zeros (0, 3);
  for part = [0.5 0.7 0.85 0.95 1.02 1.05 1.1 1.2]
    curve(end+1,:) = [part*beyond, predicted_growth(name, part*beyond), growth(part*beyond)];
  endfor
  rows = struct ("method", name, "what", {"h omega at which a step lets the amplitude grow by 1 %", ...
                                          "limit of h omega", "limit of the step [s]"}, ...
                 "predicted", {beyond, limit, limit/mode.omega}, "measured", {measured, NaN, NaN});
  table = integrator_table (system.forms);
  if (table(strcmp ({table.name}, name)).adaptive)
    rows(end+1) = struct ("method", name, "what", sprintf ("mean h omega at a loose tolerance (limit %.4g)", limit), ...
                          "predicted", NaN, "measured", wall (system, mode, name));
  endif
  told (rows);
endfunction

function rows = told (rows)
  for row = rows
    say ("  %-20s %-58s %12.6g %12.6g", row.method, row.what, row.predicted, row.measured);
  endfor
endfunction

## the mean step times the frequency that no tolerance lets an adaptive method pass, NaN where it fails
function h_omega = wall (system, mode, name)
  seconds = 400/mode.omega;
  system.initial_state += mode.shape;  # a micrometre
  h_omega = NaN;
  try
    [~, count] = integrate (system, [0, seconds], struct ("name", name, "tolerance", 1));
    h_omega = seconds/count.steps*mode.omega;
  catch err
    rethrow_others (err, "toolchain:integration");
  end_try_catch
endfunction

## of the highest mode's amplitude in 20 steps, beside what the same time does to it
function factor = measured_growth (system, mode, name, h_omega, exact)
  seconds = 20*h_omega/mode.omega;
  amplitude = mode_amplitudes (system, mode, name, seconds/20, [0, seconds])(2);
  factor = (amplitude/exact (seconds))^(1/20);
  if (isnan (factor))
    factor = Inf;
  endif
endfunction

## a function of the time (s), to that of 20 steps a third beyond rk4's limit: by steps so short that nothing grows
function exact = true_amplitudes (system, mode)
  times = (0:5:75)/mode.omega;
  found = mode_amplitudes (system, mode, "rk4", 0.35/mode.omega, times);
  exact = @(t) interp1 (times, found, t, "spline", NaN);
endfunction

%!error <cannot be made|can be written> scene_stability ("paper", "output", "/proc/nowhere")
%!error <nothing oscillates> scene_stability ("spin_up", "modes", [0 0], "output", tempdir ())
%!test # measured limits are the predicted ones, of every kind of scene
%! scenes = {setfield(paper (), "model", "modes", [0 1]), chain(1), setfield(large_swing (), "model", "modes", [4 4]), ...
%!           setfield(arc_pendulum (), "model", "modes", [0 2]), setfield(spin_up (), "model", "modes", [0 2])};
%! for scene = scenes
%!   [folder, gone] = scratch_folder ();
%!   evalc ("table = scene_stability (scene{1}, 'output', folder);");
%!   grown = table(strncmp ({table.what}, "h omega at which", 16));
%!   assert ([grown.measured], [grown.predicted], -0.01);
%!   assert (numel (grown) >= 3);
%!   walls = table(strncmp ({table.what}, "mean h omega", 12));  # beyond the limit it grows, first slowly
%!   assert ([walls.measured]./cellfun (@stability_limit, {walls.method}), 1.2*ones (size (walls)), 0.45);
%!   assert (stat (fullfile (folder, "stability.png")).size > 10000);
%! endfor
