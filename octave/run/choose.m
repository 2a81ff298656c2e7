## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} choose (@var{ladder}, @var{tolerance}, @var{useless})
## The smallest rung of a kind's ladder of models that has every point within the @var{tolerance} (m) in every frame.
##
## The rung above a first guess is the reference, whose motion says how much of it is needed.  That is run, and a
## little more until it holds: until it is within the ladder's share of the tolerance of the reference.  Then smaller
## rungs are tried, a part after the other, for as long as they hold too.  Where what is needed is not clearly less
## than the reference has, a quarter of what all rungs drop is near enough, where that is more, and otherwise it is the
## next guess.  At the ladder's end the choice gives up: the last reference is taken, with its distance from the best
## that is clearly poorer, and a warning says so.  No rung is run twice, and one that cannot be run is passed by; where
## none can, the error is the last one's.  It gives up, too, after a reference that bends too far (see
## @code{refuse_steep}), or two that cannot be integrated.
##
## The choice ends with the first reference that is @var{useless} (reference), by default none: where no rung is
## believed to serve, how small it may be matters to nobody.
##
## @var{ladder} is a struct of share, parts (a cell array) and functions: first () = [rung, why] (a sentence, or
## empty), richer (rung), smaller (rung, part), the same rung where there is none, left_out (reference, rung, part),
## what a rung leaves out of a part of the reference's motion (m; NaN: that cannot be told, Inf: it cannot do without),
## dropped (trial), what all rungs leave out (m), poorer (rung, reference), whether the reference is so much richer
## that it tells the rung's error, trial (rung, like) (see @code{try_rung}), drift (trial), how far that is off by its
## integration (m; see @code{phase_drift}), sharper (trial), the ladder whose trials drift less, and name (rung).
##
## @var{choice}: trial (the chosen one), reference (what it is compared with), rung, error_m (their distance), reason
## (a sentence), useless (whether the trial is so), tried (a struct array of rung, name, error_m, seconds, calls,
## message, chosen) and warnings (cellstr).
## @end deftypefn

function choice = choose (ladder, tolerance, useless = @(reference) false)
  limit = ladder.share*tolerance;
  trials = references = failures = {};
  [guess, why] = ladder.first ();
  do
    references{end+1} = ladder.richer (guess);
    [reference, trials] = run_once (ladder, references{end}, trials);
    failures{end+1} = reference.identifier;
    gives_up = isempty (reference.error) && useless (reference);
    if (gives_up)
      trial = reference;
      break;
    endif
    [trial, next, trials, limit] = near_enough (ladder, reference, limit, trials);
    if (isempty (trial) && isempty (reference.error) && ladder.drift (reference) > 4*limit)
      ladder = ladder.sharper (reference);
      trials = references = {};  # and the same guess
    else
      guess = next;
    endif
    at_the_end = any (cellfun (@(rung) isequal (rung, ladder.richer (guess)), references));
  until (! isempty (trial) || at_the_end || is_hopeless (failures))

  reason = sprintf ("the smallest within %.2g m of %s", limit, ladder.name (reference.rung));
  warnings = {};
  if (gives_up)
    reason = "the first that was run, no other is believed to serve";
  elseif (isempty (trial))
    [trial, reference] = richest_ran (ladder, references, trials);
    reason = "the largest, none was found to be within the tolerance";
    warnings = {sprintf(["the choice of the model gave up: %s, the largest, and %s are %.2g m apart, at most" ...
                         " %.2g m were wanted: take a larger tolerance, smoother loads, or state model.modes"], ...
                        ladder.name (trial.rung), ladder.name (reference.rung), distance (trial, reference), ...
                        limit)};
  endif
  if (! isempty (why))
    reason = [why "; " reason];
  endif
  choice = struct ("trial", trial, "reference", reference, "rung", trial.rung, ...
                   "error_m", distance (trial, reference), "reason", reason, "warnings", {warnings}, ...
                   "useless", gives_up);
  choice.tried = cellfun (@(trial) entry (ladder, trial, reference, choice.rung), trials);
endfunction

## richer rods bend as far, and what cannot be integrated twice will not be
function yes = is_hopeless (failures)
  steep = strcmp (failures, "toolchain:integration:steep");
  yes = steep(end) || (numel (failures) > 1 && all (strcmp (failures(end-1:end), "toolchain:integration")));
endfunction

function row = entry (ladder, trial, reference, chosen)
  row = struct ("rung", trial.rung, "name", ladder.name (trial.rung), "error_m", distance (trial, reference), ...
                "seconds", trial.seconds, "calls", trial.count.calls, "message", trial.error, ...
                "chosen", isequal (trial.rung, chosen));
endfunction

%!function ladder = series (amplitudes, least = 0)   # the motion is a sum, a rung its number of terms
%!  sum_of = @(n) sum (amplitudes(1:n));
%!  ladder = struct ("share", 0.95, "parts", {{"terms"}});
%!  ladder.richer = @(n) min (2*n + 2, numel (amplitudes));
%!  [ladder.first, ladder.smaller] = deal (@() deal (1, "they fall"), @(n, part) max (n - 1, 0));
%!  ladder.left_out = @(reference, n, part) abs (sum_of (reference.rung) - sum_of (n));
%!  [ladder.poorer, ladder.dropped, ladder.drift] = deal (@clearly_fewer, @(trial) 0, @(trial) 0);
%!  ladder.trial = @(n, like) run_terms (n, sum_of (n), least);
%!  ladder.name = @(n) sprintf ("%d terms", n);
%!endfunction
%!function trial = run_terms (n, x, least)
%!  if (n < least)
%!    error ("toolchain:scene", "%d terms are locked\n", n);
%!  endif
%!  trial = struct ("x", x, "y", 0, "count", struct ("calls", n));
%!endfunction
%!test # three terms are the fewest within the tolerance, and no number of terms is run twice
%! choice = choose (series (0.1.^(0:19)), 1.2e-3);
%! assert (choice.rung, 3); assert (choice.error_m, 0.1^3*1.111, 1e-6); assert (choice.warnings, {});
%! assert (choice.reason, "they fall; the smallest within 0.0011 m of 8 terms");
%! assert (sort ([choice.tried.rung]), [3 4 8]); assert ([choice.tried([choice.tried.chosen]).rung], 3);
%!test # the first reference that is useless is taken, not one that failed
%! choice = choose (series (0.1.^(0:19)), 1.2e-3, @(trial) true);
%! assert ({[choice.tried.rung], choice.useless}, {4, true}); assert (isempty (strfind (choice.reason, "smallest")));
%! choice = choose (series (0.1.^(0:19), 5), 1.2e-3, @(trial) true);
%! assert ([choice.rung, numel(choice.tried)], [10 2]);
%!test # where as much is needed as the reference has, the reference is the next guess
%! choice = choose (series (0.5.^(0:19)), 1e-3);
%! assert (choice.rung, 12); assert (sort ([choice.tried.rung]), [4 10 11 12 20]);
%!test # where as much is needed, but all rungs drop more than that, four times what is left out, the first serves
%! choice = choose (setfield (series (0.5.^(0:19)), "dropped", @(trial) 2), 1e-3);
%! assert (choice.rung, 2); assert (choice.error_m, 0.5^2*1.5, 1e-12);
%! assert (choice.reason, "they fall; the smallest within 0.47 m of 4 terms");
%! assert (choose (setfield (series (0.5.^(0:19)), "dropped", @(trial) 1e-3), 1e-3).rung, 12);
%!test # a reference that drifts off makes trials sharper, and the choice begins again
%! drifting = setfield (series (0.1.^(0:19)), "drift", @(trial) 1);
%! drifting.trial = @(n, like) run_terms (n, n, 0);  # each as far from the others as it may
%! drifting.sharper = @(reference) series (0.1.^(0:19));
%! choice = choose (drifting, 1.2e-3);
%! assert (choice.rung, 3); assert (sort ([choice.tried.rung]), [3 4 8]); assert (choice.warnings, {});
%!test # what cannot be run is passed by, and its message kept
%! choice = choose (series ([1 0 0 0 0 0 0 0], 4), 0.1);
%! assert (choice.rung, 4); assert (choice.warnings, {});
%! assert (choice.tried(strcmp ({choice.tried.message}, "1 terms are locked")).error_m, Inf);
%!test # it says that it gave up, and does not give the distance from itself
%! choice = choose (series (1./(1:20)), 1e-3);
%! assert (choice.rung, 20); assert (choice.error_m, sum (1./(11:20)), 1e-12);
%! assert (choice.warnings, {["the choice of the model gave up: 20 terms, the largest, and 10 terms are 0.67 m" ...
%!   " apart, at most 0.00095 m were wanted: take a larger tolerance, smoother loads, or state model.modes"]});
%! assert (isempty (strfind (choice.reason, "smallest")));
%!test # what only the last could do is compared with nothing
%! choice = choose (series (0.1.^(0:19), 20), 1e-3);
%! assert (choice.rung, 20); assert (choice.error_m, Inf);
%!function ladder = that_fails (how)
%!  ladder = setfield (series (0.1.^(0:19)), "trial", @(n, like) error (how, "%d failed\n", n));
%!endfunction
%!error <4 failed> choose (that_fails ("toolchain:integration:steep"), 1)  # no richer one is tried
%!error <10 failed> choose (that_fails ("toolchain:integration"), 1)  # nor a third
%!error <20 failed> choose (that_fails ("toolchain:scene"), 1)
%!error <20 terms are locked> choose (series (0.1.^(0:19), 21), 1e-3);
