## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} mechanism_kind ()
## Several bodies, held by joints, among the kinds of scenes (see @code{kind_of}); or one rod with joints, where one of
## them constrains it, dampers couple its modes, or it is curved.
## @end deftypefn

function kind = mechanism_kind ()
  kind.name = "mechanism";
  kind.has = @(given) true;
  kind.check = @check_mechanism;
  kind.pixel = @(scene) plane_pixel (scene, scene.longest);
  kind.models = @(scene) [scene.bodies.model];
  kind.stated = @stated_rung;
  kind.ladder = @mechanism_ladder;
  kind.far_richer = @far_richer_rung;
  kind.build = @(scene, rung) build_mechanism (scene, mechanism_rungs (scene, rung.bending, rung.longitudinal));
  kind.system = @assembled_system;
  kind.led_by = @led_by_run;
  kind.observe = @observe_mechanism;
  ## what is damped falls about as the tolerance's square root
  kind.tighter = @(solver, off) setfield (solver, "tolerance", solver.tolerance*min (max ((5e-8/off)^2, 1e-3), 0.1));
  kind.dropped = @(scene, run, reference) dropped_of_bodies (scene, run.model, run.history);
  kind.bound = @(scene, run) dropped_of_bodies (scene, run.model, run.history).metres;
  kind.instead = @(scene) exact_or (exact_bodies (scene));
  kind.foreseen = @(scene, model) {};
  kind.describe = @describe_mechanism;
  kind.limits = @limits_of_bodies;
  kind.warnings = @body_warnings;
  kind.columns = @mechanism_columns;
  kind.drawing = @(scene, run) mechanism_drawing (scene, run.model, run.history);
  kind.panels = @(scene, run) mechanism_panels (scene, run.history);
  kind.spectrum = @body_spectrum;
  kind.rungs = @rungs_around;
  kind.exactly = @exact_bodies;
  kind.of_exact = @(scene) mechanism_kind ();
  kind.literal = @(scene) [];
  kind.sized = @model_of_size;
  kind.at_rest = @mechanism_at_rest;
  kind.turning = @steady_mechanism;
  kind.reference = {"radau", 1e-12};
endfunction

function limits = limits_of_bodies (scene, run)
  limits = struct ("what", {}, "limit", {}, "reached", {});
  for k = 1:numel (scene.bodies)
    for limit = limits_of_body (scene, run, k)
      limits(end+1) = setfield (limit, "what", [scene.bodies(k).name ": " limit.what]);
    endfor
  endfor
endfunction

function [rung, note] = stated_rung (scene)
  rung = [];
  note = "";
  if (! any (arrayfun (@(body) ischar (body.model.modes), scene.bodies)))
    rung = same_for_all (scene, 0, 0);  # bodies have what they state
    note = stiffening_note_of_bodies (scene);
  endif
endfunction

function rung = same_for_all (scene, bending, longitudinal)
  each = ones (1, numel (scene.bodies));
  rung = struct ("bending", bending*each, "longitudinal", longitudinal*each);
endfunction

## of the bodies that do not state theirs, or where all do of all
function model = model_of_size (scene, n)
  chosen = arrayfun (@(body) ischar (body.model.modes), scene.bodies);
  for k = find (chosen(:).' | ! any (chosen))
    scene.bodies(k).model.modes = "auto";
  endfor
  rung = same_for_all (scene, n, n);
  exact = arrayfun (@(body) strcmp (body.model.stiffening, "exact"), scene.bodies(:).');
  rung.longitudinal(exact) = ceil (n/2);  # what is stretched is smooth
  model = build_mechanism (scene, mechanism_rungs (scene, rung.bending, rung.longitudinal));
endfunction

function rungs = rungs_around (scene, chosen, richer)
  rungs = {};
  for n = [0 1 2 3 5 8](1:sum ([0 1 2 3 5 8] < max (richer.bending)))
    rungs{end+1} = same_for_all (scene, n, 0);
  endfor
  rungs = [rungs, {chosen}, {richer}];
  again = find (cellfun (@(rung) isequal (rung, chosen), rungs))(2:end);
  rungs(again) = [];
endfunction

function rung = far_richer_rung (scene, mechanism)
  for name = {"bending", "longitudinal"}
    rung.(name{1}) = 2*cellfun (@(model) model.rung.(name{1}), mechanism.models) + 6;
  endfor
endfunction

## with the derivatives of the constraints by the coordinates at the start (constraints-by-n)
function run = observe_mechanism (scene, model, system, times, states)
  history = measure_mechanism (system, times, named_rows (system, states));
  run = mechanism_points (model, history);
  run.history = history;
  start = named_rows (system, system.initial_state);
  [~, run.start_jacobian] = system.matrices (system.at (0, start.q, start.v));
endfunction

%!test # bodies keep what they state
%! scene = check_mechanism (setfield (chain (2), "duration", 0.02));
%! [model, choice] = chosen_model (mechanism_kind (), scene);
%! assert (cellfun (@(model) model.rung.bending, model.models), [1 1]);
%! assert (choice.reason, "given by the scene; stiffening = \"auto\" is none where numbers of modes are stated");
%!test # what the chooser has said, or that the run by another solver is off by more than the tolerance
%! scene = setfield (chain (1), "duration", 0.04);
%! scene.bodies{1}.model.modes = "auto";
%! scene.solver = struct ("name", "variational", "step", 0.02, "tolerance", 1e-7);
%! result = driver (scene, "output", "");
%! assert (result.summary.estimated_error_m > 1e-7);
%! said = @(text) any (! cellfun (@isempty, strfind (result.summary.warnings, text)));
%! assert (said ("the estimated error is"));
%! assert (isempty (strfind (result.summary.model_reason, "the largest")));
%!test # half a pixel of the longest rod
%! [~, ~, scene] = sample_mechanism ([0 1]);
%! assert (mechanism_kind ().pixel (scene), 2.5*0.5/720, 1e-12);
%!test # how it asks for a balance, richer models, and rungs around a chosen one
%! kind = mechanism_kind ();
%! tighter = @(off) kind.tighter (struct ("tolerance", 1), off).tolerance;
%! assert (arrayfun (tighter, [1e-7 5e-7 1]), [0.1 0.01 1e-3], 1e-12);
%! [system, start, scene] = sample_mechanism ([1 2]);
%! richer = kind.far_richer (scene, system.mechanism);
%! assert (richer, struct ("bending", [10 10 10], "longitudinal", [8 8 8]));
%! rung = @(bending) struct ("bending", bending, "longitudinal", [0 0 0]);
%! rungs = kind.rungs (scene, rung ([0 2 1]), rung ([3 4 4]));
%! assert (cell2mat (cellfun (@(rung) rung.bending, rungs.', "uniformoutput", false)), ...
%!         [0 0 0; 1 1 1; 2 2 2; 3 3 3; 0 2 1; 3 4 4]);
%! rungs = kind.rungs (scene, rung ([1 1 1]), rung ([2 2 2]));
%! assert (cellfun (@(rung) rung.bending(1), rungs), [0 1 2]);
%! assert (kind.stated (scene), struct ("bending", [0 0 0], "longitudinal", [0 0 0]));
%! assert (cellfun (@(model) model.rung.bending, kind.sized (scene, 3).models) >= 3, true (1, 3));
%!test # limits of the first body, too
%! scene = check_mechanism (setfield (chain (2), "duration", 0.02));
%! [model, choice] = chosen_model (mechanism_kind (), scene);
%! limits = mechanism_kind ().limits (scene, balanced_run (mechanism_kind (), scene, model, choice));
%! assert (unique (strtok ({limits.what}, ":")), {scene.bodies.name});
