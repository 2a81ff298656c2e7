## -*- texinfo -*-
## @deftypefn {} {[@var{model}, @var{choice}] =} chosen_model (@var{kind}, @var{scene}, @var{left}, @
##   @var{useless})
## The model of a checked scene of a @var{kind} (see @code{kind_of}): that which is known (see @code{known_rung}), or
## the smallest that serves it, which @code{choose} finds.  @var{choice} is what that returns; where nothing was chosen
## its trial is empty (see @code{given_choice}).  What takes more than a third of the seconds @var{left} () is given up
## (see @code{ladder_of}), and what is @var{useless} ends the choice (see @code{choose}).
## @end deftypefn

function [model, choice] = chosen_model (kind, scene, left = @() Inf, useless = @(trial) false)
  [rung, choice] = known_rung (kind, scene);
  if (isempty (rung))
    choice = choose (ladder_of (kind, scene, left), scene.solver.tolerance, useless);
    model = choice.trial.model;
  else
    model = kind.build (scene, rung);
  endif
endfunction

%!test
%! scene = check_scene (setfield (paper (), "model", "modes", [1 2]));
%! [model, choice] = chosen_model (kind_of (scene), scene);
%! assert (rung_name (model.rung), "1 + 2 sines");
%! assert (choice.trial, []);
%! assert (choice.reason, "given by the scene; stiffening = \"auto\" is none where numbers of modes are stated");
%!test # of each kind, chosen
%! chosen = @(scene) setfield (scene, "model", "modes", "auto");
%! for scene = {setfield(swing (), "duration", 0.1), setfield(chosen (chain (2)), "duration", 0.02), ...
%!              setfield(large_swing (), "duration", 0.04)}
%!   kind = kind_of (scene{1});
%!   scene = kind.check (scene{1});
%!   [model, choice] = chosen_model (kind, scene);
%!   assert (choice.error_m <= scene.solver.tolerance);
%!   assert (fieldnames (kind.build (scene, choice.rung)), fieldnames (model));
%! endfor
