## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} rod_kind ()
## One straight rod, hinged at O or in a hub, among the kinds of scenes (see @code{kind_of}).
## @end deftypefn

function kind = rod_kind ()
  kind.name = "rod";
  kind.has = @(given) ! is_curved (given) && one_rod (given);
  kind.check = @check_scene;
  kind.pixel = @(scene) plane_pixel (scene, scene.rod.length);
  kind.models = @(scene) scene.model;
  kind.stated = @stated_rung;
  kind.ladder = @rod_ladder;
  kind.far_richer = @far_richer_rung;
  kind.build = @build_model;
  kind.system = @rod_system;
  kind.led_by = @(system, run) system;
  kind.observe = @observe_rod;
  kind.tighter = @(solver, off) setfield (solver, "tolerance", solver.tolerance*min (max (1e-7/off, 1e-3), 0.1));
  kind.dropped = @dropped_of_rod;
  kind.bound = @(scene, run) NaN;
  kind.instead = @(scene) exact_or (exact_rod (scene));
  kind.foreseen = @spin_warning;
  kind.describe = @describe_rod;
  kind.limits = @(scene, run) rod_limits (scene, run.model, run.history);
  kind.warnings = @(scene, run) validity_warnings (scene, run.model, run.history);
  kind.columns = @rod_columns;
  kind.drawing = @(scene, run) rod_drawing (scene, run.model, run.history);
  kind.panels = @(scene, run) rod_panels (run.history, undeformed_tip (run.model));
  kind.spectrum = @tip_spectrum;
  kind.rungs = @rungs_around;
  kind.exactly = @exact_rod;
  kind.of_exact = @of_exact_rod;
  kind.literal = @paper_sines;
  kind.sized = @(scene, n) build_model (scene, rung_of_scene (setfield (scene, "model", "modes", [n n])));
  kind.at_rest = [];
  kind.turning = @(scene) steady_rod (rod_kind (), scene);
  kind.reference = {"waveform", 1e-10};
endfunction

## on the plane, whose polynomials of places must resolve how a slender rod keeps its length, or as a body, which has
## stretch and bending apart, and all joints, but no deformed start
function [exact, lacks] = exact_rod (scene)
  section = rod_section (scene.rod, scene.model);
  slender = section.EA*scene.rod.length^2 > 1e6*section.EI;
  on_plane = all (ismember ({scene.joints.kind}, {"spring", "force", "moment"}));
  exact = [];
  if (slender || ! on_plane)
    [exact, lacks] = exact_body (scene);
  endif
  if (on_plane && isempty (exact))
    [exact, lacks] = exact_scene (scene);
  endif
endfunction

function kind = of_exact_rod (exact)
  kind = exact_body_kind ();
  if (isfield (exact, "surface"))
    kind = exact_kind ();
  endif
endfunction

function [rung, note] = stated_rung (scene)
  rung = [];
  note = "";
  if (isnumeric (scene.model.modes))
    rung = rung_of_scene (scene);
    note = stiffening_note (scene.model, rung.bending);
  endif
endfunction

function rung = far_richer_rung (scene, model)
  along = 30*! strcmp (scene.model.axial, "none");
  rung = struct ("sines", [], "bending", 30, "longitudinal", along, "axial", "dynamic", "stiffening", "foreshortening");
  if (along == 0)
    rung.axial = "none";
  endif
  if (strcmp (scene.model.stiffening, "none"))
    rung.stiffening = "none";
  endif
endfunction

function run = observe_rod (scene, model, system, times, states)
  run.history = measure (system, model, times, states);
  [run.x, run.y] = centreline (model, linspace (0, model.length, 21), run.history, 1);
endfunction

function rungs = rungs_around (scene, chosen, richer)
  rungs = ladder_rungs (chosen, richer);
  known = axial_treatments (scene);
  rungs = rungs(cellfun (@(rung) any (strcmp (rung.axial, known)), rungs));
endfunction

## whose literal equations have a hinge, weight and a moment
function rung = paper_sines (scene)
  rung = [];
  more = ! isempty (scene.rotation) || ! isempty (scene.force) || scene.tip_mass > 0 || ! isempty (scene.joints);
  if (! more)
    rung = rung_of_scene (setfield (scene, "model", "modes", [7 7]));
  endif
endfunction

function own = describe_rod (scene, run)
  rung = run.model.rung;
  own.model = rung_name (rung);
  own.modes = [rung.longitudinal, rung.bending];
  own.axial = rung.axial;
  own.stiffening = rung.stiffening;
  own.energy = scene.model.energy;
  own.moment_work = scene.model.moment_work;
  own.rotary_inertia = logical (scene.model.rotary_inertia);
endfunction

%!test # what is stated, with what its stiffening means
%! stated = rod_kind ().stated;
%! [rung, note] = stated (check_scene (setfield (paper (), "model", "modes", [1 2])));
%! assert (rung_name (rung), "1 + 2 sines");
%! assert (note, "stiffening = \"auto\" is none where numbers of modes are stated");
%! assert (stated (check_scene (paper ())), []);
%!test # how it asks for a balance, far richer models, and what is said of a run
%! kind = rod_kind ();
%! tighter = @(off) kind.tighter (struct ("tolerance", 1), off).tolerance;
%! assert (arrayfun (tighter, [1e-7 1e-5 1]), [0.1 0.01 1e-3], 1e-12);
%! of = @(varargin) kind.far_richer (check_scene (setfield (varargin{:})), []);
%! assert (rung_name (of (paper (), "zoom", 1)), "30 bending + 30 longitudinal modes, foreshortening");
%! assert (rung_name (of (paper (), "model", "axial", "none")), "30 bending modes, foreshortening");
%! assert (rung_name (of (paper (), "model", "stiffening", "none")), "30 bending + 30 longitudinal modes");
%! assert (kind.literal (check_scene (paper ())).sines, [7 7]);
%! for field = {"tip_mass", "force"; 1, @(t) [1 0]}
%!   assert (kind.literal (check_scene (setfield (paper (), field{:}))), []);
%! endfor
%! assert (kind.literal (check_scene (spin_up ())), []);
%! scene = check_scene (setfield (paper (), "model", "modes", [1 2]));
%! own = kind.describe (scene, struct ("model", build_model (scene, rung_of_scene (scene))));
%! assert (own.model, "1 + 2 sines"); assert (own.modes, [1 2]);
%! assert ({own.axial, own.stiffening, own.energy}, {"dynamic", "none", "paper"});
%! assert (own.moment_work, scene.model.moment_work);
%! assert (own.rotary_inertia, logical (scene.model.rotary_inertia));
%! observed = trial_run (check_scene (setfield (paper (), "duration", 0.02)), rung_of_scene (scene));
%! assert (size (observed.x), [21, numel(observed.history.t)]);
%! assert (observed.x(end,:), observed.history.tip_x, 1e-12);
