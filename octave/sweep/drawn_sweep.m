## -*- texinfo -*-
## @deftypefn {} {@var{drawn} =} drawn_sweep (@var{found}, @var{texts})
## What @code{draw_sweep} takes of what a sweep has @var{found}, of which the observed have these @var{texts}: x, a row
## a point, and names of the columns in which its points have more than one value, where those are numbers; none where
## there are more than two of them, or others than numbers, or nothing that was observed is a number.
## @end deftypefn

function drawn = drawn_sweep (found, texts)
  words = cellfun (@value_words, found.values, "uniformoutput", false);
  varied = arrayfun (@(j) numel (unique (words(:,j))) > 1, 1:numel (found.columns));
  of_numbers = cellfun (@(value) isnumeric (value) && isscalar (value), found.values(:,varied));
  y = reshape (str2double (found.observed), size (found.observed));
  drawn = struct ("x", [], "names", {{}}, "y", y, "texts", {texts}, "failed", ! found.done);
  if (any (varied) && sum (varied) <= 2 && all (of_numbers(:)) && any (isfinite (y(:))))
    drawn.x = cell2mat (found.values(:,varied));
    drawn.names = found.columns(varied);
  endif
endfunction

%!function drawn = of (values, observed = {"1"; "rigid"})
%!  count = rows (values);
%!  found = struct ("columns", {{"a", "b", "c"}(1:columns (values))}, "values", {values}, "observed", {observed}, ...
%!                  "done", [true false]);
%!  drawn = drawn_sweep (found, {"u"});
%!endfunction
%!test
%! assert (of ({1 5; 2 5}), struct ("x", [1; 2], "names", {{"a"}}, "y", [1; NaN], "texts", {{"u"}}, ...
%!                                  "failed", [false true]));
%! assert (of ({1 5 "x"; 2 6 "x"}).names, {"a", "b"}); assert (of ({1 5 "x"; 2 6 "x"}).x, [1 5; 2 6]);
%! assert (of ({1 "x"; 2 "x"}).names, {"a"});
%!test # texts, rows of numbers, more than two, none; nothing to draw over them
%! for values = {{1 "x"; 2 "y"}, {1 [0 4]; 1 [0 5]}, {1 2 3; 2 3 4}, {1; 1}}
%!   assert (isempty (of (values{1}).x));
%! endfor
%! assert (isempty (of ({1; 2}, {"a"; "b"}).x));
