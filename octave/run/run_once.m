## -*- texinfo -*-
## @deftypefn {} {[@var{trial}, @var{trials}] =} run_once (@var{ladder}, @var{rung}, @var{trials})
## The trial of a @var{rung} (see @code{try_rung}): that among the @var{trials} (a cell array), or a new one, which is
## then among them.
## @end deftypefn

function [trial, trials] = run_once (ladder, rung, trials)
  known = find (cellfun (@(trial) isequal (trial.rung, rung), trials), 1);
  if (isempty (known))
    ran = cellfun (@(trial) isempty (trial.error), trials);
    trials{end+1} = try_rung (ladder, rung, [trials{find(ran, 1, "last")}]);
    known = numel (trials);
  endif
  trial = trials{known};
endfunction

%!test
%! ladder.name = @(n) sprintf ("%d", n);
%! ladder.trial = @(n, like) struct ("x", n, "y", rand ());
%! [first, trials] = run_once (ladder, 3, {});
%! [second, trials] = run_once (ladder, 3, trials);
%! assert (second, first); assert (numel (trials), 1);
%! [~, trials] = run_once (ladder, 4, trials);
%! assert (numel (trials), 2);
%! ladder.trial = @(n, like) struct ("x", n, "y", [like.x]);
%! [third, trials] = run_once (ladder, 5, trials);
%! assert (third.y, 4);  # led by the last one alone
