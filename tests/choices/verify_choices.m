## -*- texinfo -*-
## @deftypefn {} {@var{table} =} verify_choices (@var{draw}, @var{option}, @var{value}, @dots{})
## Is what a run says of its error true?  The first scenes of each sort of the scene @var{draw} (a file, as
## @code{drawn_scene}) choose their model, all shipped ones, 60, 80, 30 and 28 or the option "counts", and are compared
## with what they truly do (see @code{true_figures}): the true error must be within the tolerance, and the estimate 0.3
## to 10 times it (or it is below a twentieth of the tolerance); the smaller models of one straight rod must miss the
## tolerance.  Says which are not so.
##
## The scenes are the points of a @code{sweep}, whose options are those of engines, jobs, limits and so on; the folder
## output/choices, or that of the option "output", has its files, and choices.svg and choices.png.  The same call again
## runs what is missing.  @var{table} is a struct array of name, sort, error, estimate, smaller (in tolerances; NaN
## where a scene failed) and good.
## @end deftypefn

function table = verify_choices (draw, varargin)
  [options, own] = without_options (varargin, {"output", "counts"});
  own = struct ("output", fullfile ("output", "choices"), "counts", [Inf 60 80 30 28], own{:});
  counts = own.counts;
  counts(1) = min (counts(1), numel (scenes_that_choose ()));
  points = cell (0, 2);
  for sort = 1:numel (counts)
    points = [points; num2cell([repmat(sort, counts(sort), 1), (1:counts(sort)).'])];
  endfor
  found = sweep (draw, [{"argument.1", "argument.2"}; points], "pictures", false, "exact", "auto", "observe", ...
                 "title, model, tolerance_m, estimated_error_m, truth.error_m, truth.smaller_m", ...
                 "output", own.output, options{:});
  table = rows_of (found);
  arrayfun (@report, table(! [table.good]));
  say ("%d of %d scenes are as promised, the largest error is %.2g tolerances", sum ([table.good]), numel (table), ...
       max ([table.error, 0]));
  publish_study (struct ("folder", own.output, "pictures", true), {}, {"choices.svg", "choices.png"}, ...
                 @(aside) [], @(scratch) draw_choices (table, scratch));
endfunction

function table = rows_of (found)
  sorts = {"shipped", "plain", "loaded", "curved", "surface"};
  numbers = str2double (found.observed(:,3:6));
  for k = rows (found.observed):-1:1
    [title, model] = found.observed{k,1:2};
    if (! found.done(k))
      [title, model] = deal (point_words (found.columns, found.values(k,:)), found.message{k});
    endif
    [tolerance, estimate, off, smaller] = num2cell (numbers(k,:)){:};
    honest = (estimate >= 0.3*off && estimate <= 10*off) || off < tolerance/20;
    table(k) = struct ("name", [title ": " model], "sort", sorts{found.values{k,1}}, "error", off/tolerance, ...
                       "estimate", estimate/tolerance, "smaller", smaller/tolerance, ...
                       "good", off <= tolerance && honest && ! (smaller < 0.95*tolerance));
  endfor
endfunction

function report (row)
  text = sprintf ("error %.3g of the tolerance, estimate %.3g", row.error, row.estimate);
  if (! isnan (row.smaller))
    text = sprintf ("%s, next smaller model %.3g", text, row.smaller);
  endif
  say ("not as promised: %s: %s", row.name, text);
endfunction

%!function table = of_rows (numbers)   # of tolerance, estimate, error and smaller, a row a scene; the last has failed
%!  n = rows (numbers);
%!  observed = [repmat({"A rod", "rigid"}, n, 1), arrayfun(@(x) sprintf ("%g", x), numbers, "uniformoutput", false)];
%!  observed(n,:) = {""};
%!  found = struct ("columns", {{"argument.1", "argument.2"}}, "values", {num2cell([5*ones(n, 1), (1:n).'])}, ...
%!                  "observed", {observed}, "done", (1:n) < n, "message", {repmat({"it is locked"}, 1, n)});
%!  setappdata (0, "found", found);
%!  stand_ins = {"found = sweep", "varargin", "found = getappdata (0, 'found');"
%!               "names = scenes_that_choose", "", "names = {'a', 'b'};"
%!               "job = draw_choices", "table, scratch", "setappdata (0, 'table', table); error ('no gnuplot');"};
%!  verify = @(folder) verify_choices ("drawn_scene.m", "counts", [3 0 1], "output", folder);
%!  in_scratch (@(folder, scratch) with_stand_ins (stand_ins, @() verify (folder)));
%!  table = getappdata (0, "table");
%!endfunction
%!test # too far off, promised too much, too little, near enough to nothing, a smaller model that would do, failed
%! said = evalc (["table = of_rows (1e-3*[1 0.5 0.6 2; 1 1.5 1.2 NaN; 1 0.1 0.5 NaN; 1 1e-4 0.049 NaN; ", ...
%!                                    "1 0.5 0.6 0.9; 1 0.5 0.04 2; 1 0.7 0.06 2; NaN NaN NaN NaN]);"]);
%! assert ([table.good], logical ([1 0 0 1 0 1 0 0])); assert ([table(1:3).error], [0.6 1.2 0.5], 1e-12);
%! assert ({table([1 end]).name}, {"A rod: rigid", "argument.1=5; argument.2=8: it is locked"});
%! assert (table(1).sort, "surface"); assert ([table([1 5]).smaller], [2 0.9], 1e-12);
%! lines = strsplit (strtrim (said), "\n");
%! assert (lines{1}, "not as promised: A rod: rigid: error 1.2 of the tolerance, estimate 1.5");
%! assert (sum (strncmp (lines, "not as", 6)), 5);
%! assert (lines{6}, "3 of 8 scenes are as promised, the largest error is 1.2 tolerances");
