## -*- texinfo -*-
## @deftypefn {} {[@var{mechanism}, @var{choice}] =} choose_mechanism (@var{scene})
## The mechanism with the fewest modes whose centrelines are within the scene's tolerance in every frame, for bodies with
## model.modes = "auto" (see @code{mechanism_rungs}); other bodies keep what they state.
##
## The levels of all rise together until the next ones but one move no point by more than half the tolerance; then each body
## goes down for as long as that holds.  @var{choice}: tried (a struct array of levels, error_m, seconds) and error (m; []
## where nothing was chosen), levels.
## @end deftypefn

function [mechanism, choice] = choose_mechanism (scene)
  open = arrayfun (@(body) ischar (body.model.modes), scene.bodies);
  choice = struct ("tried", struct ("levels", {}, "error_m", {}, "seconds", {}), "error", [], "levels", zeros (1, numel (open)));
  if (! any (open))
    mechanism = build_mechanism (scene, mechanism_rungs (scene, choice.levels));
    return;
  endif
  limit = scene.solver.tolerance/2;
  trial = @(levels) setfield (mechanism_trial (scene, mechanism_rungs (scene, levels)), "levels", levels);
  runs = {trial(0*open)};
  do
    level = numel (runs);
    runs{end+1} = trial (level*open);
    error = Inf;
    if (level > 1)
      error = distance (runs{end-2}, runs{end});
      choice.tried = [choice.tried, struct("levels", runs{end-2}.levels, "error_m", error, "seconds", runs{end-2}.seconds)];
    endif
  until (error <= limit || level >= 12)
  [best, reference] = deal (runs{end-2}, runs{end});
  for k = find (open)
    while (best.levels(k) > 0)
      levels = best.levels;
      levels(k)--;
      smaller = trial (levels);
      off = distance (smaller, reference);
      choice.tried = [choice.tried, struct("levels", levels, "error_m", off, "seconds", smaller.seconds)];
      if (off > limit)
        break;
      endif
      [best, error] = deal (smaller, off);
    endwhile
  endfor
  [mechanism, choice.error, choice.levels] = deal (best.mechanism, error, best.levels);
endfunction

%!test # a soft rod needs modes, a stiff one none
%! rod = struct ("length", 0.5, "EA", 1e6, "EI", 5, "rhoA", 1);
%! model = struct ("modes", "auto", "energy", "uniaxial");
%! scene.bodies = {struct("rod", setfield (rod, "EI", 1e6), "model", model), struct("rod", rod, "model", model)};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), struct("kind", "revolute", "bodies", [1 2], "stations", [0.5 0])};
%! scene.duration = 0.2; scene.solver.tolerance = 1e-4;
%! [~, choice] = choose_mechanism (check_mechanism (scene));
%! assert (choice.levels, [0 1]); assert (choice.error < 0.5e-4);
