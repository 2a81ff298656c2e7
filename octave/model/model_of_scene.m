## -*- texinfo -*-
## @deftypefn {} {[@var{model}, @var{choice}] =} model_of_scene (@var{scene})
## The model of a checked scene: the paper's sines where model.modes gives their numbers, and otherwise the smallest
## that serves it.  @var{choice} comes from @code{choose_model}, or @code{choose_curved}; where nothing was chosen
## its trial is empty.
## @end deftypefn

function [model, choice] = model_of_scene (scene)
  if (ischar (scene.model.modes))
    choice = {@choose_model, @choose_curved}{1 + ! isempty(scene.rod.curvature)}(scene);
    model = choice.trial.model;
  else
    model = build_model (scene, rung_of_scene (scene));
    choice = struct ("trial", [], "reason", "given by the scene", "tried", [], "warnings", {{}});
  endif
endfunction

%!test
%! [model, choice] = model_of_scene (check_scene (setfield (paper (), "model", "modes", [1 2])));
%! assert (rung_name (model.rung), "1 + 2 sines");
%! assert (choice.reason, "given by the scene");
