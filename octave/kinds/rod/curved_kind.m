## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} curved_kind ()
## One curved rod, hinged at O, among the kinds of scenes (see @code{kind_of}): as a straight one, but for its ladder of
## base functions and for what they drop, since their strains are linear in displacements.
## @end deftypefn

function kind = curved_kind ()
  kind = rod_kind ();
  kind.name = "curved rod";
  kind.has = @(given) is_curved (given) && one_rod (given);
  kind.stated = @stated_rung;
  kind.ladder = @curved_ladder;
  kind.far_richer = @(scene, model) curved_rung ([27*! strcmp(scene.model.axial, "none"), 40]);
  kind.build = @build_curved_model;
  kind.dropped = @dropped_of_curved;
  kind.bound = @(scene, run) bound_of_curved (run.model, run.history.V, scene.duration);
  stiffer = "take a stiffer rod or smaller loads, a curved rod's strains are linear in its displacements";
  kind.instead = @(scene) exact_or (exact_body (scene), stiffer);
  kind.rungs = @(scene, chosen, richer) curved_rungs (chosen, richer);
  kind.exactly = @exact_body;
  kind.of_exact = @(scene) exact_body_kind ();
  kind.literal = @(scene) [];
  kind.turning = @(scene) steady_rod (curved_kind (), scene);
  kind.sized = @(scene, n) build_curved_model (scene, rung_of_scene (setfield (scene, "model", "modes", [n n])));
endfunction

## none has foreshortening
function [rung, note] = stated_rung (scene)
  rung = rod_kind ().stated (scene);
  note = "";
endfunction

%!test # what is stated, far richer models, and what to take where all drop too much
%! kind = curved_kind ();
%! scene = check_scene (setfield (arc_pendulum (), "model", "modes", [1 2]));
%! [rung, note] = kind.stated (scene);
%! assert (rung.sines, [1 2]); assert (note, "");
%! assert (kind.far_richer (check_scene (arc_pendulum ()), []).sines, [27 40]);
%! assert (kind.far_richer (check_scene (setfield (arc_pendulum (), "model", "axial", "none")), []).sines, [0 40]);
%! assert (kind.literal (scene), []); assert (kind.sized (scene, 3).rung.sines, [3 3]);
%! assert (strncmp (kind.instead (scene), "EXACT=yes", 9));
%! thick = kind.instead (check_scene (setfield (hook (), "rod", "half_height", 0.01)));
%! assert (! isempty (strfind (thick, "linear in its displacements")));
