## -*- texinfo -*-
## @deftypefn {} {[@var{trial}, @var{guess}, @var{trials}, @var{limit}] =} near_enough (@var{ladder}, @
##   @var{reference}, @var{limit}, @var{trials})
## The smallest trial near the @var{reference} as @code{smallest_near} finds it (see there): within the @var{limit} (m),
## or, where none is, within the ladder's share of a quarter of what all rungs drop, as the last one that ran tells,
## where that is more; it is the @var{limit} then.
## @end deftypefn

function [trial, guess, trials, limit] = near_enough (ladder, reference, limit, trials)
  [trial, guess, trials] = smallest_near (ladder, reference, limit, trials);
  if (isempty (trial) && isempty (reference.error))
    ran = trials(cellfun (@(trial) isempty (trial.error), trials));
    dropped = ladder.share*ladder.dropped (ran{end})/4;
    if (dropped > limit)
      limit = dropped;
      [trial, guess, trials] = smallest_near (ladder, reference, limit, trials);
    endif
  endif
endfunction

%!function ladder = halves (dropped)   # the motion is a sum of powers of a half, a rung its number of terms
%!  sum_of = @(n) sum (0.5.^(0:n-1));
%!  ladder = struct ("share", 0.95, "parts", {{"terms"}}, "poorer", @clearly_fewer);
%!  ladder.smaller = @(n, part) max (n - 1, 0);
%!  ladder.left_out = @(reference, n, part) abs (sum_of (reference.rung) - sum_of (n));
%!  ladder.trial = @(n, like) struct ("x", sum_of (n), "y", 0);
%!  [ladder.name, ladder.dropped] = deal (@(n) sprintf ("%d terms", n), @(trial) dropped);
%!endfunction
%!test # of ten terms none clearly fewer is within 0.002, nor within a quarter of 0.01, but six within a quarter of 0.13
%! ladder = halves (0.01);
%! [trial, guess, trials, limit] = near_enough (ladder, try_rung (ladder, 10), 2e-3, {try_rung(ladder, 3)});
%! assert ({trial, guess}, {[], 9}); assert (limit, 0.95*0.01/4, 1e-15);
%! ladder = halves (0.13);
%! [trial, ~, ~, limit] = near_enough (ladder, try_rung (ladder, 10), 2e-3, {try_rung(ladder, 3)});
%! assert (trial.rung, 6); assert (limit, 0.95*0.13/4, 1e-15);
%!test # what is near enough needs no larger limit
%! [trial, ~, ~, limit] = near_enough (halves (1), try_rung (halves (1), 10), 0.04, {});
%! assert ([trial.rung, limit], [6 0.04]);
