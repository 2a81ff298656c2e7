## -*- texinfo -*-
## @deftypefn {} {[@var{mechanism}, @var{choice}] =} choose_mechanism (@var{scene})
## The mechanism with the fewest modes whose centrelines are within the scene's tolerance in every frame, for bodies
## with model.modes = "auto" (see @code{mechanism_rungs}); other bodies keep what they state.
##
## The levels of all rise together until the next ones but one move no point by more than half the tolerance; then each
## body goes down for as long as that holds, and does without longitudinal modes where it can: they are the fastest.
## @var{choice}: tried (a struct array of levels, longitudinal, error_m, seconds), error (m) and trial (see
## @code{mechanism_trial}; [] where nothing was chosen), levels, longitudinal.
## @end deftypefn

function [mechanism, choice] = choose_mechanism (scene)
  open = arrayfun (@(body) ischar (body.model.modes), scene.bodies);
  none = 0*open;
  choice = struct ("tried", struct ("levels", {}, "longitudinal", {}, "error_m", {}, "seconds", {}), "error", [], ...
                   "trial", [], "levels", none, "longitudinal", none);
  if (! any (open))
    mechanism = build_mechanism (scene, mechanism_rungs (scene, none));
    return;
  endif
  limit = scene.solver.tolerance/2;
  runs = {trial_of(scene, none, none)};
  do
    level = numel (runs);
    runs{end+1} = trial_of (scene, level*open, longitudinal_modes (level*open));
    if (level > 1)
      choice = noted (choice, runs{end-2}, runs{end});
    endif
  until (level > 1 && (choice.error <= limit || level >= 12))
  reference = runs{end};
  for k = find (open)
    do
      best = choice.trial;
      if (best.levels(k) > 0)
        less = best.levels - ((1:numel (open)) == k);
        along = min (best.longitudinal, longitudinal_modes (less));
        choice = lower (choice, trial_of (scene, less, along), reference, limit);
      endif
    until (isequal (choice.levels, best.levels))
    if (choice.longitudinal(k) > 0)
      without = choice.longitudinal.*((1:numel (open)) != k);
      choice = lower (choice, trial_of (scene, choice.levels, without), reference, limit);
    endif
  endfor
  mechanism = choice.trial.mechanism;
endfunction

function trial = trial_of (scene, levels, longitudinal)
  trial = mechanism_trial (scene, mechanism_rungs (scene, levels, longitudinal));
  [trial.levels, trial.longitudinal] = deal (levels, longitudinal);
endfunction

function choice = noted (choice, trial, reference)
  choice.error = distance (trial, reference);
  choice.tried = [choice.tried, struct("levels", trial.levels, "longitudinal", trial.longitudinal, ...
                                       "error_m", choice.error, "seconds", trial.seconds)];
  [choice.trial, choice.levels, choice.longitudinal] = deal (trial, trial.levels, trial.longitudinal);
endfunction

## the smaller model, where that is within the limit
function choice = lower (choice, trial, reference, limit)
  smaller = noted (choice, trial, reference);
  choice.tried = smaller.tried;
  if (smaller.error <= limit)
    choice = smaller;
  endif
endfunction

%!test # a soft rod needs modes, a stiff one none
%! rod = struct ("length", 0.5, "EA", 1e6, "EI", 5, "rhoA", 1);
%! model = struct ("modes", "auto", "energy", "uniaxial");
%! scene.bodies = {struct("rod", setfield (rod, "EI", 1e6), "model", model), struct("rod", rod, "model", model)};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                 struct("kind", "revolute", "bodies", [1 2], "stations", [0.5 0])};
%! scene.duration = 0.2; scene.solver.tolerance = 1e-4;
%! [~, choice] = choose_mechanism (check_mechanism (scene));
%! assert (choice.levels, [0 1]); assert (choice.error < 0.5e-4);
