## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} surface_kind ()
## A rod on a surface, among the kinds of scenes (see @code{kind_of}).  The rod fills a frame's smaller side.
## @end deftypefn

function kind = surface_kind ()
  kind.name = "surface";
  kind.has = @(given) isfield (given, "surface");
  kind.check = @check_surface_scene;
  kind.pixel = @(scene) scene.rod.length/min (scene.frame_size);
  kind.models = @(scene) scene.model;
  kind.stated = @stated_rung;
  kind.ladder = @surface_ladder;
  kind.far_richer = @(scene, model) min (2*model.numbers.modes, 32);
  kind.build = @(scene, rung) surface_rod (setfield (scene, "model", "modes", rung));
  kind.system = @(scene, model) model;
  kind.led_by = @led_on_surface;
  kind.observe = @observe_surface;
  kind.tighter = @tighter;
  kind.dropped = @(scene, run, reference) [];
  kind.bound = @(scene, run) 0;
  kind.instead = @(scene) "";
  kind.foreseen = @(scene, model) {};
  kind.describe = @describe_surface;
  kind.limits = @limits_of_rod;
  kind.warnings = @(scene, run) surface_warnings (scene, run.history, limits_of_rod (scene, run));
  kind.columns = @surface_columns;
  kind.drawing = @(scene, run) surface_drawing (run.model, scene, run.history);
  kind.panels = @(scene, run) surface_panels (scene, run.history);
  kind.spectrum = @surface_spectrum;
  kind.rungs = @rungs_around;
  kind.exactly = @(scene) lacking ("a surface, on which it is exact");
  kind.of_exact = @(scene) surface_kind ();
  kind.literal = @(scene) [];
  kind.sized = @model_of_size;
  kind.at_rest = @surface_at_rest;
  kind.turning = @steady_surface;
  kind.reference = {"radau", 1e-10};
endfunction

## Radau's method damps what stretches, small as its way may be, until its steps resolve it; Gauss's keeps its energy.
function solver = tighter (solver, off)
  if (off > 5e-6)
    solver.name = "gauss";
  else
    solver.tolerance *= min (5e-8/off, 0.1);
  endif
endfunction

function [rung, note] = stated_rung (scene)
  rung = [];
  note = "";
  if (isnumeric (scene.model.modes))
    rung = scene.model.modes;
  endif
endfunction

function run = observe_surface (scene, model, system, times, states)
  run.history = measure_surface (system, scene, times, states);
  refuse_self_contact (run.history, scene);
  [run.x, run.y, run.z] = deal (run.history.x, run.history.y, run.history.z);
endfunction

function model = model_of_size (scene, n)
  model = [];
  if (n >= 4 && n <= 32)
    model = surface_rod (setfield (scene, "model", "modes", [n n]));
  endif
endfunction

function rungs = rungs_around (scene, chosen, richer)
  numbers = unique ([5 6 7 8 10 12 chosen(1) richer(1)]);  # fewer lock
  rungs = arrayfun (@(n) [n n], numbers(numbers <= max (chosen(1), richer(1))), "uniformoutput", false);
endfunction

function own = describe_surface (scene, run)
  history = run.history;
  numbers = run.model.numbers;
  own.model = sprintf ("%d + %d base functions on the surface %s", numbers.modes + numbers.sines, scene.surface.name);
  own.surface = scene.surface;
  own.modes = numbers.modes;
  own.sines = numbers.sines;
  own.ends = scene.ends;
  own.angular_momentum_change = max (abs (history.angular_momentum - history.angular_momentum(:,1)), [], 2).';
  own.largest_strain = history.largest_strain;
  own.reaction = [min(history.reaction(:)), max(history.reaction(:))];
  last = cumsum (numbers.modes + numbers.sines);
  own.largest_end_coefficient = max (abs (history.q(last,:))(:))/scene.rod.length;
endfunction

function limits = limits_of_rod (scene, run)
  limits = struct ("what", "axial strain", "limit", 0.05, "reached", run.history.largest_strain);
endfunction

%!test # by the driver's name, without files
%! scene = setfield (large_swing (), "duration", 0.1);
%! result = driver (scene, "output", "", "modes", [5 5]);
%! assert (numel (result.history.t), 6);
%! assert (result.summary.largest_energy_error < 1e-7);
%!error <speed is not a field of a scene on a surface> driver (setfield (large_swing (), "speed", 1), "output", "")
%!test # models of a size, and far richer ones, as long as they are not too large
%! kind = surface_kind ();
%! model = @(n) struct ("numbers", struct ("modes", [n n]));
%! assert (cellfun (@(n) kind.far_richer ([], model (n))(1), {5, 15, 20}), [10 30 32]);
%! assert ({kind.sized([], 3), kind.sized([], 33)}, {[], []});
%! assert (kind.sized (check_surface_scene (large_swing ()), 4).numbers.modes, [4 4]);
%! assert (kind.sized (check_surface_scene (large_swing ()), 32).numbers.modes, [32 32]);
%!test # what is said of a run, its pixel, and how the solver is asked for a balance
%! kind = surface_kind ();
%! scene = struct ("surface", struct ("name", "cone"), "rod", struct ("length", 2), "ends", {{"free", "free"}}, ...
%!                 "frame_size", [1280 720]);
%! assert (kind.pixel (scene), 2/720, 1e-15);
%! run.history = struct ("angular_momentum", [1 1.5 1; 0 -3 1; 7 7 7], "largest_strain", 0.01, ...
%!                       "reaction", [3 -4; 8 1], "q", [0.1 0.1; -0.4 0.3; 0.2 0.2; 0.1 0.1; -0.2 0.6]);
%! run.model.numbers = struct ("modes", [2 2], "sines", [0 1]);
%! own = kind.describe (scene, run);
%! assert (own.model, "2 + 3 base functions on the surface cone");
%! assert ({own.surface, own.modes, own.sines, own.ends}, {scene.surface, [2 2], [0 1], scene.ends});
%! assert (own.angular_momentum_change, [0.5 3 0]); assert (own.largest_strain, 0.01);
%! assert (own.reaction, [-4 8]); assert (own.largest_end_coefficient, 0.3);
%! tighter = @(off) kind.tighter (struct ("tolerance", 1), off).tolerance;
%! assert (arrayfun (tighter, [1e-7 1e-6 1e-4]), [0.1 0.05 1], 1e-12);
%! assert (cell2mat (kind.rungs (scene, [6 6], [9 9]).'), [5 6 7 8 9].'*[1 1]);
%! assert (numel (kind.rungs (scene, [6 6], [13 13])), 7);
%!test # a balance that is far off is Gauss's to keep, at the same tolerance
%! solver = surface_kind ().tighter (struct ("name", "auto", "tolerance", 1e-4), 1e-5);
%! assert (solver, struct ("name", "gauss", "tolerance", 1e-4));
%! solver = surface_kind ().tighter (struct ("name", "auto", "tolerance", 1e-4), 1e-6);
%! assert (solver.name, "auto"); assert (solver.tolerance, 5e-6, 1e-18);
