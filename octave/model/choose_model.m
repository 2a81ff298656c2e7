## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} choose_model (@var{scene})
## The smallest rung of the ladder whose centreline is within the scene's tolerance in every frame, for
## model.modes = "auto".  @code{predict_rung} guesses it from the loads; a richer rung is the reference, whose motion
## says how many modes are needed.  A rung holds if it differs from the reference by at most 95 % of the tolerance;
## where none does, the reference is the next guess.  From the one that holds, smaller ones are tried for as long as
## they hold too: of the longitudinal modes, of the bending modes, and without foreshortening.
##
## @var{choice}: trial (the chosen one, see @code{trial_run}), reference (the richer one), error (their distance, m),
## reason (a sentence), tried (a struct array of rung, name, error_m, seconds, calls), warnings (cellstr).
## @end deftypefn

function choice = choose_model (scene)
  limit = 0.95*scene.solver.tolerance;
  [rung, why] = predict_rung (scene);
  tried = {};
  do
    richer = richer_rung (rung, scene);
    reference = trial_run (scene, richer);
    rung = needed_of (reference, limit);
    trial = trial_run (scene, rung);
    tried = [tried, {reference, trial}];
    while (distance (trial, reference) > limit && rung.bending < richer.bending && isempty (reference.error))
      rung.bending++;
      tried{end+1} = trial = trial_run (scene, rung);
    endwhile
    verified = distance (trial, reference) <= limit && rung.bending <= 0.8*richer.bending + 1 ...
               && rung.longitudinal <= 0.8*richer.longitudinal + 1;
    largest = isequal (richer_rung (richer, scene), richer);
    rung = richer;
  until (verified || largest)

  for part = {"axial", "bending", "stiffening"}
    do
      smaller = smaller_rung (trial.rung, part{1}, scene);
      held = false;
      known = find (cellfun (@(t) isequal (t.rung, smaller), tried), 1);
      if (isempty (known))
        tried{end+1} = trial_run (scene, smaller);
        known = numel (tried);
      endif
      held = ! isequal (smaller, trial.rung) && distance (tried{known}, reference) <= limit;
      if (held)
        trial = tried{known};
      endif
    until (! held)
  endfor

  choice = struct ("trial", trial, "reference", reference, "error", distance (trial, reference), "reason", why, ...
                   "warnings", {{}});
  entry = @(t) struct ("rung", t.rung, "name", rung_name (t.rung), "error_m", distance (t, reference), ...
                       "seconds", t.seconds, "calls", t.calls);
  choice.tried = cellfun (entry, tried);
  if (! isempty (reference.error))
    error ("toolchain:integration", "%s\n", reference.error);
  elseif (! verified)
    choice.warnings = {sprintf(["the largest model, %s, is not shown to be within the tolerance of %.2g m" ...
                                " (estimate %.2g m): take a larger tolerance, or smoother loads"], ...
                               rung_name (reference.rung), scene.solver.tolerance, choice.error)};
  endif
endfunction

## as many modes of the richer model as are needed where the others are left out of its motion
function rung = needed_of (reference, limit)
  rung = reference.rung;
  if (isempty (reference.error))
    [along, across] = functions_at (reference.model.base, linspace (0, reference.model.length, 21).');
    n1 = columns (reference.model.basis) - rung.bending;
    rung.longitudinal = count_needed (along, reference, 0, n1, limit);
    rung.bending = count_needed (across, reference, n1, rung.bending, limit);
    if (strcmp (rung.axial, "dynamic"))
      rung.longitudinal = max (rung.longitudinal, 1);
    endif
  endif
endfunction

function n = count_needed (functions, reference, first, n, limit)
  left_out = 0;
  while (n > 0)
    left_out += functions*reference.model.basis(:,first+n)*reference.history.q(first+n,:);
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
%! assert (choice.error < 2e-5);
%! smaller = choice.trial.rung; smaller.bending--;
%! assert (distance (trial_run (scene, smaller), choice.reference) > 1.9e-5);
