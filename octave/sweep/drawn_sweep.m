## -*- texinfo -*-
## @deftypefn {} {@var{drawn} =} drawn_sweep (@var{found}, @var{texts})
## What @code{draw_sweep} and @code{draw_parallel} take of what a sweep has @var{found}, of which the observed have
## these @var{texts}: x, a row a point, and names of the columns in which its points have more than one value; those
## that are not all one number have @var{words} (a cellstr, or empty), and x has which of them.  There are none where
## nothing that was observed is a number, or words are one or two columns.
## @end deftypefn

function drawn = drawn_sweep (found, texts)
  words = cellfun (@value_words, found.values, "uniformoutput", false);
  varied = arrayfun (@(j) numel (unique (words(:,j))) > 1, 1:numel (found.columns));
  of_numbers = all (cellfun (@(value) isnumeric (value) && isscalar (value), found.values), 1);
  y = reshape (str2double (found.observed), size (found.observed));
  drawn = struct ("x", [], "names", {{}}, "words", {{}}, "y", y, "texts", {texts}, "failed", ! found.done);
  if (any (varied) && any (isfinite (y(:))) && (sum (varied) > 2 || all (of_numbers(varied))))
    drawn.names = found.columns(varied);
    for j = find (varied)(:).'
      [drawn.x(:,end+1), drawn.words{end+1}] = axis_values (found.values(:,j), words(:,j), of_numbers(j));
    endfor
  endif
endfunction

function [x, words] = axis_values (values, words, are_numbers)
  if (are_numbers)
    [x, words] = deal (vertcat (values{:}), {});
  else
    [words, ~, x] = unique (words);
    [words, x] = deal (words(:).', x(:));
  endif
endfunction

%!function drawn = of (values, observed = {"1"; "rigid"})
%!  count = rows (values);
%!  found = struct ("columns", {{"a", "b", "c"}(1:columns (values))}, "values", {values}, "observed", {observed}, ...
%!                  "done", [true false]);
%!  drawn = drawn_sweep (found, {"u"});
%!endfunction
%!test
%! expected = struct ("x", [1; 2], "names", {{"a"}}, "words", {{{}}}, "y", [1; NaN], "texts", {{"u"}}, ...
%!                    "failed", [false true]);
%! assert (of ({1 5; 2 5}), expected);
%! assert (of ({1 5 "x"; 2 6 "x"}).names, {"a", "b"}); assert (of ({1 5 "x"; 2 6 "x"}).x, [1 5; 2 6]);
%! assert (of ({1 "x"; 2 "x"}).names, {"a"});
%!test # three, of which two are words
%! drawn = of ({1 "x" [0 4]; 2 "a" [0 3]});
%! assert (drawn.x, [1 2 2; 2 1 1]); assert (drawn.words, {{}, {"a", "x"}, {"0 3", "0 4"}});
%!test # texts, rows of numbers, none; nothing to draw over them
%! for values = {{1 "x"; 2 "y"}, {1 [0 4]; 1 [0 5]}, {1; 1}}
%!   assert (isempty (of (values{1}).x));
%! endfor
%! assert (isempty (of ({1; 2}, {"a"; "b"}).x));
