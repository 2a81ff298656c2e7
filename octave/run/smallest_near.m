## -*- texinfo -*-
## @deftypefn {} {[@var{trial}, @var{needed}, @var{trials}] =} smallest_near (@var{ladder}, @var{reference}, @
##   @var{limit}, @var{trials})
## The trial of the smallest rung of a @var{ladder} (see @code{choose}) that is clearly poorer than the
## @var{reference}, a trial, and within the @var{limit} (m) of it: what is needed of its motion, or else one
## of the @var{trials} before, and from there down.  Empty where none is: then @var{needed} is the rung to go on from.
## @end deftypefn

function [trial, needed, trials] = smallest_near (ladder, reference, limit, trials)
  trial = [];
  needed = reference.rung;
  if (! isempty (reference.error))
    return;
  endif
  metres = limit;
  do
    needed = needed_of (ladder, reference, metres);
    if (! ladder.poorer (needed, reference.rung))
      return;
    endif
    [near, trials] = run_once (ladder, needed, trials);
    held = distance (near, reference) <= limit;
    metres /= 2;
  until (held || metres < limit/100)
  if (! held)
    needed = reference.rung;
    [near, held] = held_before (ladder, reference, limit, trials);
  endif
  if (held)
    [trial, trials] = go_down (ladder, near, reference, limit, trials);
  endif
endfunction

## the smallest rung that leaves at most so many metres out of the motion of the reference in each part
function rung = needed_of (ladder, reference, metres)
  rung = reference.rung;
  for part = ladder.parts
    do
      before = rung;
      smaller = ladder.smaller (rung, part{1});
      if (ladder.left_out (reference, smaller, part{1}) <= metres)
        rung = smaller;
      endif
    until (isequal (rung, before))
  endfor
endfunction

function [trial, trials] = go_down (ladder, trial, reference, limit, trials)
  for part = ladder.parts
    do
      before = trial.rung;
      rung = ladder.smaller (before, part{1});
      hopeless = ladder.left_out (reference, rung, part{1}) > 2*limit;
      if (! hopeless && ! isequal (rung, before))
        [smaller, trials] = run_once (ladder, rung, trials);
        if (distance (smaller, reference) <= limit)
          trial = smaller;
        endif
      endif
    until (isequal (trial.rung, before))
  endfor
endfunction

## the last of the other trials that is clearly poorer and near the reference, if there is one
function [near, held] = held_before (ladder, reference, limit, trials)
  near = [];
  holds = @(trial) ladder.poorer (trial.rung, reference.rung) && distance (trial, reference) <= limit;
  last = find (cellfun (holds, trials), 1, "last");
  held = ! isempty (last);
  if (held)
    near = trials{last};
  endif
endfunction

%!function ladder = series (amplitudes, seen)   # the motion is a sum, a rung its number of terms
%!  sum_of = @(n) sum (amplitudes(1:n));
%!  ladder = struct ("parts", {{"terms"}}, "smaller", @(n, part) max (n - 1, 0), "poorer", @clearly_fewer);
%!  ladder.left_out = @(reference, n, part) seen*abs (sum_of (reference.rung) - sum_of (n));
%!  ladder.trial = @(n, like) struct ("x", sum_of (n), "y", 0);
%!  ladder.name = @(n) sprintf ("%d terms", n);
%!endfunction
%!test # three terms are within 0.002; so they are found where the motion shows a fifth or thrice of what is left
%! for seen = [0.2 1 3]
%!   ladder = series (0.1.^(0:9), seen);
%!   trial = smallest_near (ladder, try_rung (ladder, 10), 2e-3, {});
%!   assert (trial.rung, 3);
%! endfor
%!test # all terms are needed
%! ladder = series (ones (1, 9), 1);
%! [trial, needed, trials] = smallest_near (ladder, try_rung (ladder, 9), 0.1, {});
%! assert (trial, []); assert (needed, 9); assert (trials, {});
%!test # nothing is seen of what is left out, but a trial before holds
%! ladder = series (0.1.^(0:9), 0);
%! trial = smallest_near (ladder, try_rung (ladder, 10), 2e-3, {try_rung(ladder, 4)});
%! assert (trial.rung, 3);
%!test # where nothing holds, or the reference failed, the reference is the rung to go on from
%! ladder = series (0.1.^(0:9), 0);
%! [trial, needed] = smallest_near (ladder, try_rung (ladder, 10), 2e-3, {});
%! assert (trial, []); assert (needed, 10);
%! failed = setfield (try_rung (ladder, 10), "error", "it shrank");
%! [trial, needed] = smallest_near (ladder, failed, 2e-3, {});
%! assert (trial, []); assert (needed, 10);
%!test # what leaves out just the limit is within it: three terms of powers of two, the only ones that are run
%! ladder = series (2.^-(0:9), 1);
%! [trial, ~, trials] = smallest_near (ladder, try_rung (ladder, 10), sum (2.^-(3:9)), {});
%! assert (trial.rung, 3); assert (cellfun (@(trial) trial.rung, trials), 3);
