## -*- texinfo -*-
## @deftypefn {} {@var{ladder} =} curved_ladder (@var{scene})
## The ladder of models (see @code{choose}) of a checked scene of one curved rod: numbers of longitudinal and bending
## base functions (see @code{curved_functions}), from the rigid rod, or from what its initial state needs, to 27 + 40.
## @end deftypefn

function ladder = curved_ladder (scene)
  initial = scene.initial;
  least = [max(numel (initial.V1), numel (initial.V1_dot)), max(numel (initial.V2), numel (initial.V2_dot))];
  most = [27 40].*[! strcmp(scene.model.axial, "none"), 1];
  ladder.share = 0.7;  # the rest is for what all its models drop
  ladder.parts = {1, 2};
  ladder.first = @() deal (curved_rung (min (max ([1 2], least), most)), "");
  ladder.richer = @(rung) curved_rung (min (2*rung.sines + [1 2], most));
  ladder.smaller = @(rung, part) curved_rung (max (rung.sines - ((1:2) == part), least));
  ladder.left_out = @(reference, rung, part) left_out (reference.model, reference.history.V, part, rung.sines(part));
  ladder.poorer = @(rung, reference) clearly_fewer (rung.sines, reference.sines);
  ladder.label = @(rung) rung_label (setfield (rung, "sines", []));
  ladder.labels = "bending base functions; +n: n longitudinal ones";
  ladder.curve = @(rung) "rungs";
  ladder.solver = setfield (setfield (scene.solver, "name", "auto"), "tolerance", scene.solver.tolerance/5);
  ladder.name = @(rung) strrep (rung_name (rung), "sines", "base functions");
endfunction

%!test
%! scene = check_scene (setfield (arc_pendulum (), "duration", 0.2));
%! scene.solver.tolerance = 1e-3;
%! choice = choose (ladder_of (curved_kind (), scene), 1e-3);
%! assert (choice.error_m <= 1e-3); assert (choice.warnings, {});
%! rich = trial_run (scene, setfield (setfield (choice.rung, "sines", [12 18]), "axial", "dynamic"));
%! true_error = distance (choice.trial, rich);
%! assert (true_error <= 1e-3); assert (choice.error_m/true_error, 1, 0.3);
%!test # from the modes of the initial state to 27 + 40, solved to a fifth of the tolerance
%! scene = arc_pendulum ();
%! scene.initial.V1 = [0 1e-6 0]; scene.initial.V2_dot = [0 0 0 1e-6];
%! scene = check_scene (scene);
%! scene.solver.tolerance = 1e-3;
%! ladder = curved_ladder (scene);
%! assert (ladder.solver.tolerance, 2e-4, 1e-15); assert (ladder.solver.name, "auto");
%! [rung, ~] = ladder.first ();
%! assert (rung.sines, [3 4]); assert (ladder.smaller (rung, 1).sines, [3 4]);
%! assert (ladder.label (rung), "4+3");
%! assert (ladder.richer (rung).sines, [7 10]); assert (ladder.smaller (ladder.richer (rung), 2).sines, [7 9]);
%! assert (ladder.richer (ladder.richer (ladder.richer (rung))).sines, [27 40]);
%! scene.model.axial = "none"; scene.initial.V1 = scene.initial.V2_dot = [];
%! ladder = curved_ladder (scene);
%! [rung, ~] = ladder.first ();
%! assert (rung.sines, [0 2]); assert (ladder.richer (rung).sines, [0 6]);
