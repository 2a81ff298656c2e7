## -*- texinfo -*-
## @deftypefn {} {[@var{points}, @var{why}] =} follow_path (@var{path}, @var{point}, @var{left})
## The @var{points} of a @var{path} (a cell array, see @code{path_point}; event: a text, empty where there is none)
## from a @var{point} with its tangent, and @var{why} it ends (a text).
##
## Where the path turns unstable because equilibria bifurcate, it goes on along the branch that the structure bends
## into (see @code{branch_off}); what a limit point makes unstable is followed. It ends where the factor passes the
## last of path.factors, or falls by their range below the first, where a place has gone three times its extent, after
## 1000 steps, or where no time is @var{left} () (s).
## @end deftypefn

function [points, why] = follow_path (path, point, left)
  points = {point};
  step = path.size/50;
  for count = 1:1000
    show_progress (sprintf ("%.4g times the loads", point.x(end)));
    [next, step] = path_step (path, point, step);
    if (isempty (next))
      why = sprintf ("at %.6g times the loads, where no way on is found", point.x(end));
      break;
    endif
    [next, why] = ended (path, point, next, left, points{1});
    [chain, branched] = path_segment (path, point, next);
    points = [points, chain];
    point = chain{end};
    if (branched)
      step = path.size/50;
    elseif (! isempty (why))
      break;
    endif
    why = sprintf ("at %.6g times the loads, after %d steps", point.x(end), count);
  endfor
  show_progress ("");
endfunction

## the last point is that of the last factor
function [next, why] = ended (path, point, next, left, first)
  why = "";
  last = path.factors(end);
  if (next.x(end) >= last)
    why = sprintf ("at %g times the loads, the last factor", last);
    there = path_at_factors (path, point, next, last);
    next = [there, {next}]{1};
  elseif (next.x(end) < path.factors(1) - path.range)
    why = sprintf ("at %.4g times the loads, by its range below the first factor", next.x(end));
  elseif (path.balance.size (next.x(1:end-1) - first.x(1:end-1)) > 3*path.size)
    why = sprintf ("at %.6g times the loads, where a place has gone three times its extent", next.x(end));
  elseif (left () < 0)
    why = sprintf ("at %.4g times the loads, where its time is used up: BUDGET=300 (s) gives it more", next.x(end));
  endif
endfunction

%!function [points, why] = followed (path, left = @() Inf)
%!  point = path_point (path, [path.balance.start; 0], zeros (0, 1), [0; 1]);
%!  point.tangent = path_tangent (point, [0; 1]);
%!  [points, why] = follow_path (path, point, left);
%!  points = [points{:}];
%!endfunction
%!test # an upright column goes on bent, up to the last factor
%! [points, why] = followed (sprung_column ());
%! x = [points.x];
%! assert (why, "at 1.5 times the loads, the last factor"); assert (x(2,end), 1.5);
%! assert (x(1,end), fzero (@(q) 1.5*sin (q) - q, [1 2]), 1e-10);
%! assert ({points.event}(! cellfun (@isempty, {points.event})), {"bifurcation"});
%! assert ([points.unstable], 0*x(1,:));
%!test # one that pulls itself down is followed until its range below the first factor, or until there is no time
%! path = sprung_column ();
%! path.balance.residual = @(factor, q, v, lambda) factor - q + 2*q.^2;
%! path.balance.tangent = @(factor, q, lambda) 1 - 4*q;
%! [points, why] = followed (path);
%! assert (regexprep (why, '-1\.5\d*', "-1.5"), "at -1.5 times the loads, by its range below the first factor");
%! limit = points(strcmp ({points.event}, "limit point"));
%! assert (limit.x, [0.25; 0.125], 1e-8); assert (points(end).unstable, 1);
%! [points, why] = followed (path, @() -1);
%! assert (numel (points), 2); assert (! isempty (strfind (why, "its time is used up")));
%!test # and what turns round and round, without end
%! path = sprung_column ();
%! path.balance.residual = @(factor, q, v, lambda) factor - sin (q);
%! path.balance.tangent = @(factor, q, lambda) cos (q);
%! [points, why] = followed (path);
%! assert (! isempty (strfind (why, "three times its extent"))); assert (abs (points(end).x(1)) < 3.1);
