## -*- texinfo -*-
## @deftypefn {} {[@var{model}, @var{choice}] =} model_of_scene (@var{scene})
## The model of a checked scene of one rod: the paper's sines where model.modes gives their numbers, and otherwise the
## smallest that serves it, which @code{choose} finds.  @var{choice} is what that returns; where nothing was chosen its
## trial is empty (see @code{given_choice}).
## @end deftypefn

function [model, choice] = model_of_scene (scene)
  if (ischar (scene.model.modes))
    choice = choose (ladder_of (scene), scene.solver.tolerance);
    model = choice.trial.model;
  else
    rung = rung_of_scene (scene);
    choice = given_choice (rung, stiffening_note (scene.model, rung.bending*isempty (scene.rod.curvature)));
    model = build_model (scene, rung);
  endif
endfunction

function ladder = ladder_of (scene)
  if (isempty (scene.rod.curvature))
    ladder = rod_ladder (scene);
  else
    ladder = curved_ladder (scene);
  endif
endfunction

%!test
%! [model, choice] = model_of_scene (check_scene (setfield (paper (), "model", "modes", [1 2])));
%! assert (rung_name (model.rung), "1 + 2 sines");
%! assert (choice.reason, "given by the scene; stiffening = \"auto\" is none where numbers of modes are stated");
%!test # a curved rod and a rigid one have no stiffening to speak of
%! [~, choice] = model_of_scene (check_scene (setfield (arc_pendulum (), "model", "modes", [1 2])));
%! assert (choice.reason, "given by the scene");
