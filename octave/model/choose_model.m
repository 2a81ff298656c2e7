## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} choose_model (@var{scene})
## The smallest rung of the ladder whose centreline is within the scene's tolerance in every frame, for model.modes =
## "auto".  @code{predict_rung} guesses it from the loads; a richer rung is the reference, whose motion says how many bending modes
## are needed.  A rung holds if it differs from the reference by at most three quarters of the tolerance; where none does,
## the reference is the next guess.  From the one that holds, smaller ones are tried for as long as they hold too.
##
## @var{choice}: trial (the chosen one, see @code{trial_run}), reference (the richer one), error (their distance, m), reason
## (a sentence), tried (a struct array of rung, name, error_m, seconds, calls), warnings (cellstr).
## @end deftypefn

function choice = choose_model (scene)
  limit = 0.75*scene.solver.tolerance;
  [rung, why] = predict_rung (scene);
  tried = {};
  do
    richer = richer_rung (rung, scene);
    reference = trial_run (scene, richer);
    rung.bending = min (rung.bending, bending_needed (reference, limit));
    trial = trial_run (scene, rung);
    tried = [tried, {reference, trial}];
    metres = distance (trial, reference);
    while (metres > limit && rung.bending < richer.bending && isfinite (metres))
      rung.bending++;
      tried{end+1} = trial = trial_run (scene, rung);
      metres = distance (trial, reference);
    endwhile
    verified = metres <= limit && rung.bending <= 0.8*richer.bending + 1;
    largest = isequal (richer_rung (richer, scene), richer);
    rung = richer;
  until (verified || largest)

  do
    held = false;
    for smaller = smaller_rungs (trial.rung, scene)
      if (! held && ! any (cellfun (@(t) isequal (t.rung, smaller{1}), tried)))
        tried{end+1} = trial_run (scene, smaller{1});
        held = distance (tried{end}, reference) <= limit;
        if (held)
          trial = tried{end};
        endif
      endif
    endfor
  until (! held)

  choice = struct ("trial", trial, "reference", reference, "error", distance (trial, reference), "reason", why, "warnings", {{}});
  choice.tried = cellfun (@(t) struct ("rung", t.rung, "name", rung_name (t.rung), "error_m", distance (t, reference), ...
                                       "seconds", t.seconds, "calls", t.calls), tried);
  if (! isempty (reference.error))
    scene_error ("%s", reference.error);
  elseif (! verified)
    choice.warnings = {sprintf(["the largest model, %s, is not shown to be within the tolerance of %.2g m (estimate %.2g m):" ...
                                " take a larger tolerance, or smoother loads"], rung_name (trial.rung), ...
                               scene.solver.tolerance, choice.error)};
  endif
endfunction

## as many bending modes of the richer model as are needed where the others are left out of its motion
function n = bending_needed (reference, limit)
  n = reference.rung.bending;
  [~, across] = functions_at (reference.model.base, linspace (0, reference.model.length, 21).');
  first = columns (reference.model.basis) - n;
  left_out = 0;
  while (n > 0 && isempty (reference.error))
    left_out += across*reference.model.basis(:,first+n)*reference.history.q(first+n,:);
    if (max (abs (left_out)(:)) > limit)
      break;
    endif
    n--;
  endwhile
endfunction

%!test # the paper's scene needs the foreshortening and bending modes, no longitudinal ones; one mode less is too few
%! scene = check_scene (paper ());
%! scene.duration = 0.6; scene.solver.tolerance = 2e-5;
%! choice = choose_model (scene);
%! assert (choice.trial.rung.axial, "none");
%! assert (choice.trial.rung.bending >= 2 && choice.trial.rung.bending <= 5);
%! assert (choice.error < 1.5e-5);
%! smaller = choice.trial.rung; smaller.bending--;
%! assert (distance (trial_run (scene, smaller), choice.reference) > 1.5e-5);
