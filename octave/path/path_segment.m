## -*- texinfo -*-
## @deftypefn {} {[@var{chain}, @var{branched}] =} path_segment (@var{path}, @var{point}, @var{next})
## What is on a @var{path} after a @var{point} up to the @var{next} one (see @code{path_point}), in order: events, the
## factors that path.factors has, and the next point (a cell array, @var{chain}). Where a bifurcation makes it unstable
## it ends at the first point of the branch instead (see @code{branch_off}), if there is one: then it @var{branched}.
## @end deftypefn

function [chain, branched] = path_segment (path, point, next)
  [events, turn] = path_events (path, point, next);
  [given, pass] = path_at_factors (path, point, next, path.factors);
  [~, order] = sort ([turn, pass]);
  chain = [events, given](order);
  branched = false;
  for k = 1:numel (chain)
    if (strcmp (chain{k}.event, "bifurcation") && next.unstable > point.unstable)
      side = branch_off (path, chain{k});
      branched = ! isempty (side);
      if (branched)
        chain = [chain(1:k), {side}];
        return;
      endif
    endif
  endfor
  chain{end+1} = next;
endfunction

%!function [path, point, next] = across_one ()   # of an upright column, before and after it buckles
%!  path = sprung_column ();
%!  point = path_point (path, [0; 0.4], zeros (0, 1), [0; 1]);
%!  next = path_point (path, [0; 1.1], zeros (0, 1), [0; 1]);
%!  point.tangent = next.tangent = [0; 1];
%!endfunction
%!test # a given factor, the bifurcation, and a point on the branch, which is stable
%! [path, point, next] = across_one ();
%! [chain, branched] = path_segment (path, point, next);
%! assert (cellfun (@(point) point.x(2), chain(1:2)), [0.5 1], 1e-9); assert (branched);
%! assert ({chain{2}.event, numel(chain), chain{3}.unstable}, {"bifurcation", 3, 0});
%! assert (chain{3}.x, [0.02; 0.02/sin(0.02)], 1e-10);
%!test # on the way back there is nothing to bend into
%! [path, point, next] = across_one ();
%! [chain, branched] = path_segment (path, next, point);
%! assert (branched, false); assert (cellfun (@(point) point.x(2), chain), [1 0.5 0.4], 1e-9);
