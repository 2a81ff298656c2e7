## -*- texinfo -*-
## @deftypefn {} {@var{table} =} scene_stability (@var{scene}, @var{option}, @var{value}, @dots{})
## Where explicit methods turn unstable on a scene's own equations: the limit of step times highest frequency about the
## scene's start (see @code{highest_mode}), predicted by the method's stability function and measured on the nonlinear
## equations (of a mechanism: those of its accelerations), the step that follows, and what a step 5 percent longer does.
## Arguments as for @code{driver}; the model is what a run would take.
##
## Leaves stability.csv, stability.svg and stability.png in the folder of the scene's output.  @var{table} is a struct
## array of method, what, predicted and measured, as from @code{stability}.
## @end deftypefn

function table = scene_stability (scene = "paper", varargin)
  [scene, kind, output] = study_scene (scene, varargin);
  system = at_rates (kind.system (scene, chosen_model (kind, scene)));
  mode = highest_mode (system);
  printf ("  highest frequency about the start: %.6g rad/s\n", mode.omega);
  found = struct ([]);
  curves = {};
  for method = explicit_methods (system)
    [rows, curve] = limits_of (system, mode, method{1});
    found = [found, rows];
    curves{end+1} = struct ("method", method{1}, "limit", rows(1).predicted, "points", curve);
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
    rate = ode.rate;
    ode.rate = @(t, y, interval) rate (t, y);
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
function [rows, curve] = limits_of (system, mode, name)
  limit = stability_limit (name);
  growth = @(h_omega) measured_growth (system, mode, name, h_omega);
  measured = measured_limit (@(h_omega) growth (h_omega) <= 1 + 1e-6, limit);
  curve = zeros (0, 3);
  for part = [0.5 0.7 0.85 0.95 1.02 1.05 1.1 1.2]
    curve(end+1,:) = [part*limit, predicted_growth(name, part*limit), growth(part*limit)];
  endfor
  rows = struct ("method", name, "what", {"limit of h omega", "step [s]", "growth a step, 5 % beyond"}, ...
                 "predicted", {limit, limit/mode.omega, curve(6,2)}, ...
                 "measured", {measured, measured/mode.omega, curve(6,3)});
  for row = rows
    printf ("  %-20s %-40s %12.6g %12.6g\n", row.method, row.what, row.predicted, row.measured);
  endfor
endfunction

## of the highest mode's amplitude in 60 steps, beside what the same time does to it in steps of a tenth of the limit
function factor = measured_growth (system, mode, name, h_omega)
  steps = 60;
  [~, long] = amplitudes (system, mode, name, h_omega/mode.omega, steps);
  pieces = ceil (10*h_omega/stability_limit (name));
  [~, short] = amplitudes (system, mode, name, h_omega/mode.omega/pieces, steps*pieces);
  factor = (long/short)^(1/steps);
  if (isnan (factor))
    factor = Inf;
  endif
endfunction

## at the start and after so many steps; NaN where the integration fails
function [first, last] = amplitudes (system, mode, name, h, steps)
  solver = struct ("name", name, "tolerance", 1, "step", h);
  times = [0, steps*h];
  moved = system;
  moved.initial_state += mode.shape;
  try
    [a, b] = deal (integrate (system, times, solver), integrate (moved, times, solver));
    size_of = @(k) mode.amplitude (b(:,k), a(:,k));
    [first, last] = deal (size_of (1), size_of (2));
  catch err
    if (! strcmp (err.identifier, "toolchain:integration"))
      rethrow (err);
    endif
    [first, last] = deal (NaN);
  end_try_catch
endfunction

%!error <cannot be made|can be written> scene_stability ("paper", "output", "/proc/nowhere")
%!test # measured limits are the predicted ones, of every kind of scene
%! scenes = {setfield(paper (), "model", "modes", [0 1]), chain(1), setfield(large_swing (), "model", "modes", [4 4])};
%! for scene = scenes
%!   folder = tempname (); confirm_recursive_rmdir (false, "local");
%!   unwind_protect
%!     evalc ("table = scene_stability (scene{1}, 'output', folder);");
%!     limits = table(strcmp ({table.what}, "limit of h omega"));
%!     assert ([limits.measured], [limits.predicted], -0.01);
%!     assert (numel (limits) >= 3);
%!     assert (stat (fullfile (folder, "stability.png")).size > 10000);
%!   unwind_protect_cleanup
%!     rmdir (folder, "s");
%!   end_unwind_protect
%! endfor
