## -*- texinfo -*-
## @deftypefn {} {[@var{trial}, @var{next}] =} richest_ran (@var{ladder}, @var{references}, @var{trials})
## Of the @var{trials} of a @var{ladder} (see @code{choose}; a cell array) the last that is one of the rungs
## @var{references} and could be run, and the @var{next}: the nearest to it of the others that are clearly poorer, or
## else of all, or what has no points.  Where none could be run, the error of the last trial is raised.
## @end deftypefn

function [trial, next] = richest_ran (ladder, references, trials)
  ran = trials(cellfun (@(trial) isempty (trial.error), trials));
  is_reference = cellfun (@(trial) any (cellfun (@(rung) isequal (rung, trial.rung), references)), ran);
  if (! any (is_reference))
    error (trials{end}.identifier, "%s\n", trials{end}.error);
  endif
  last = find (is_reference, 1, "last");
  trial = next = ran{last};
  next.x(:) = NaN;  # nothing to compare with
  others = ran([1:last-1, last+1:end]);
  poorer = cellfun (@(other) ladder.poorer (other.rung, trial.rung), others);
  if (any (poorer))
    others = others(poorer);
  endif
  if (! isempty (others))
    [~, nearest] = min (cellfun (@(other) distance (other, trial), others));
    next = others{nearest};
  endif
endfunction

%!function [ladder, trials] = of_numbers (x)   # a rung a number, which is 0 where it fails
%!  ladder.poorer = @(rung, reference) rung < reference - 1;
%!  for k = 1:numel (x)
%!    trials{k} = struct ("rung", k, "x", x(k), "y", 0, "error", repmat ("it broke", x(k) == 0), "identifier", "a:b");
%!  endfor
%!endfunction
%!test # the third, and of the clearly poorer first and the second the first
%! [ladder, trials] = of_numbers ([1 5 6 0]);
%! [trial, next] = richest_ran (ladder, {2, 3, 4}, trials);
%! assert ([trial.rung, next.rung], [3 1]);
%! [trial, next] = richest_ran (ladder, {2, 3}, trials(2:3));
%! assert ([trial.rung, next.rung], [3 2]);
%! [trial, next] = richest_ran (ladder, {3}, trials(3));
%! assert (next.x, NaN);
%!error <it broke> [ladder, trials] = of_numbers ([1 0]); richest_ran (ladder, {2}, trials);
