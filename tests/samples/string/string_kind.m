## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} string_kind ()
## A point mass on a heavy elastic string in the plane: a throw-away kind of scenes (see @code{kind_of}), with which
## tests/octave/throw_away_kind.m shows that a row of the table is all that a kind takes.  A rung is a number of equal
## elements.
## @end deftypefn

function kind = string_kind ()
  kind.name = "string";
  kind.has = @(given) isfield (given, "string");
  kind.check = @check;
  kind.pixel = @(scene) 2*scene.string.length/min (scene.frame_size);
  kind.models = @(scene) scene.model;
  kind.stated = @stated_rung;
  kind.ladder = @ladder_of_elements;
  kind.far_richer = @(scene, model) 2*model.elements + 6;
  kind.build = @(scene, rung) setfield (scene.string, "elements", rung);
  kind.system = @string_system;
  kind.led_by = @(system, run) system;
  kind.observe = @observe;
  kind.tighter = @(solver, off) setfield (solver, "tolerance", solver.tolerance/10);
  kind.dropped = @(scene, run, reference) [];
  kind.bound = @(scene, run) 0;
  kind.instead = @(scene) "";
  kind.foreseen = @(scene, model) {};
  kind.describe = @(scene, run) struct ("model", ["a string of " name_of(run.model.elements)]);
  kind.limits = @(scene, run) [];
  kind.warnings = @(scene, run) {};
  kind.columns = @columns_of;
  kind.drawing = @drawing_of;
  kind.panels = @panels_of;
  kind.spectrum = @(scene, run) [];
  kind.rungs = @(scene, chosen, richer) num2cell (unique ([1, chosen, richer]));
  kind.exactly = @(scene) lacking ("a string");
  kind.of_exact = @string_kind;
  kind.literal = @(scene) [];
  kind.sized = @(scene, n) setfield (scene.string, "elements", n)(n <= 4);
  kind.at_rest = [];
  kind.turning = [];
  kind.reference = {"ode45", 1e-10};
endfunction

function scene = check (given)
  scene = take_fields (without_probed (given), {
    "title",             "",         "text"
    "string.length",     NaN,        "positive number in m"
    "string.stiffness",  NaN,        "positive number in N/m"
    "string.mass",       NaN,        "positive number in kg"
    "string.rhoA",       0.02,       "positive number in kg/m"
    "gravity",           9.81,       "positive number in m/s^2"
    "initial.phi",       0,          "number in rad"
    "duration",          NaN,        "positive number in s"
    "frames_per_second", 50,         "positive number in 1/s"
    "frame_size",        [1280 720], "two even numbers of pixels from 320 to 8192 [W H]"
    "model.modes",       "auto",     "\"auto\" or positive number of elements"
    "solver.name",       "auto",     solver_names({"rate"})
    "solver.step",       [],         "positive number in s"
    "solver.tolerance",  "pixel",    "\"pixel\" or positive number in m"
  }, "a scene with a string");
  [~, scene.probed] = load_breaks (load_list (cell (0, 6)), [], scene);
  scene.solver.tolerance = tolerance_in_metres (scene.solver.tolerance, string_kind ().pixel (scene));
endfunction

function [rung, note] = stated_rung (scene)
  note = "";
  rung = scene.model.modes;
  if (ischar (rung))
    rung = [];
  endif
endfunction

function ladder = ladder_of_elements (scene)
  ladder.share = 0.5;
  ladder.parts = {"elements"};
  ladder.first = @() deal (1, "");
  ladder.richer = @(rung) min (2*rung + 1, 15);
  ladder.smaller = @(rung, part) max (rung - 1, 1);
  ladder.left_out = @(reference, rung, part) distance (reference, string_points (reference, rung));
  ladder.poorer = @clearly_fewer;
  ladder.name = @name_of;
  ladder.label = @(rung) sprintf ("%d", rung);
  ladder.labels = "elements";
  ladder.curve = @(rung) "rungs";
  ladder.solver = setfield (scene.solver, "name", "auto");
endfunction

function name = name_of (elements)
  name = sprintf ("%d elements", elements);
endfunction

function run = observe (scene, model, system, times, states)
  n = model.elements;
  run = string_points (struct ("x", [0*times; states(1:n,:)], "y", [0*times; states(n+1:2*n,:)]), 20);
  run.history = setfield (system.energies (states), "t", times);
endfunction

function [names, table] = columns_of (scene, run)
  [names, table] = energy_columns (run.history);
  names = [{"t [s]", "tip_x [m]", "tip_y [m]"}, names];
  table = [run.history.t; run.x(end,:); run.y(end,:); table];
endfunction

function drawing = drawing_of (scene, run)
  t = run.history.t;
  drawing = struct ("title", scene.title, "time", t, "frames_per_second", scene.frames_per_second, "zoom", 1, ...
                    "gravity", scene.gravity, "frame_size", scene.frame_size, "moment", 0*t, "moment_breaks", []);
  drawing.bodies = struct ("x", run.x, "y", run.y, "rest_x", run.x, "rest_y", run.y, "half_height", 0.01, ...
                           "stress", []);
  drawing.hinges = struct ("x", 0*t, "y", 0*t);
  drawing.strips = panels_of (scene, run)(1);
  drawing.equations = {};
endfunction

function panels = panels_of (scene, run)
  mass = new_panel ("mass", "m", {"x", "y"}, [run.x(end,:); run.y(end,:)]);
  panels = [mass, energy_panels(run.history)];
endfunction

%!error <string.stiffness is missing>
%! string_kind ().check (struct ("string", struct ("length", 1), "duration", 1));
%!error <colour is not a field of a scene with a string> string_kind ().check (struct ("colour", 1));
