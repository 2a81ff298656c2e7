## -*- texinfo -*-
## @deftypefn {} {[@var{mechanism}, @var{choice}] =} mechanism_of_scene (@var{scene})
## The mechanism of a checked scene, with the modes that its bodies state, or, where that is "auto", with the smallest
## models that serve it, which @code{choose} finds.  @var{choice} is what that returns; where nothing was chosen its
## trial is empty (see @code{given_choice}).
## @end deftypefn

function [mechanism, choice] = mechanism_of_scene (scene)
  open = arrayfun (@(body) ischar (body.model.modes), scene.bodies);
  if (any (open))
    choice = choose (mechanism_ladder (scene), scene.solver.tolerance);
    mechanism = choice.trial.mechanism;
  else
    rungs = mechanism_rungs (scene, 0*open);
    choice = given_choice (rungs, stiffening_of_bodies (scene));
    mechanism = build_mechanism (scene, rungs);
  endif
endfunction

%!test # bodies keep what they state
%! scene = check_mechanism (setfield (chain (2), "duration", 0.02));
%! [mechanism, choice] = mechanism_of_scene (scene);
%! assert (cellfun (@(model) model.rung.bending, mechanism.models), [1 1]);
%! assert (choice.reason, "given by the scene; stiffening = \"auto\" is none where numbers of modes are stated");
%!test # a soft rod needs modes, a stiff one none
%! rod = struct ("length", 0.5, "EA", 1e6, "EI", 5, "rhoA", 1);
%! model = struct ("modes", "auto", "energy", "uniaxial");
%! scene.bodies = {struct("rod", setfield (rod, "EI", 1e6), "model", model), struct("rod", rod, "model", model)};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [0.5 0])};
%! scene.duration = 0.2; scene.solver.tolerance = 1e-4;
%! [~, choice] = mechanism_of_scene (check_mechanism (scene));
%! assert (choice.rung.bending, [0 1]); assert (choice.rung.longitudinal, [0 0]);
%! assert (choice.error_m < 0.5e-4); assert (choice.warnings, {});
