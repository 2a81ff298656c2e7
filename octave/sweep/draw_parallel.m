## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_parallel (@var{sweep}, @var{title}, @var{scratch})
## A @var{sweep} over more than two fields in parallel coordinates (Inselberg 1985): an axis each, and one of the first
## observation that has numbers, by which the lines of the points are coloured; those that failed are dashed.  It
## leaves sweep.svg and sweep.png; arguments are as for @code{draw_sweep}.
## @end deftypefn

function job = draw_parallel (sweep, title, scratch)
  first = find (any (isfinite (sweep.y), 1), 1);
  y = sweep.y(:,first);
  count = columns (sweep.x);
  axes = cellfun (@axis_of, num2cell (sweep.x, 1), sweep.words, "uniformoutput", false);
  axes = [axes{:}, axis_of(y(isfinite (y)), {})];
  parts = arrayfun (@(j) axes(j).part (sweep.x(:,j)), 1:count, "uniformoutput", false);
  parts = [parts{:}, axes(end).part(y)];
  [~, order] = sort (y);
  drawn = order(isfinite (y(order)));
  number = arrayfun (@(j) repmat (j, 1, numel (axes(j).tics)), 1:count, "uniformoutput", false);
  range = axes(end).range;
  settings = struct ("title", title, "names", {[sweep.names, sweep.texts(first)]}, "c", range, ...
                     "c_step", tic_step (range, 5), "tic_axis", {num2cell([number{:}])}, ...
                     "tic_part", {num2cell([axes(1:count).tics])}, "tic_text", {[axes(1:count).texts]});
  text = [gnuplot_settings(settings), gnuplot_block("points", {polylines(parts(drawn,:), y(drawn))}), ...
          gnuplot_block("failed", {polylines(parts(sweep.failed,1:count), zeros (sum (sweep.failed), 1))})];
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "parallel.gp");
endfunction

## from 0 to 1: the range of the values, where a value is in it, and where texts stand beside it; words are one above
## the other
function axis = axis_of (x, words)
  range = [min(x), max(x)];
  if (range(1) == range(2))
    range += [-0.5 0.5]*max (abs (range(1)), 1);
  endif
  measure = @(x) x;
  if (! isempty (words))
    tics = 1:numel (words);
  elseif (is_wide (x))
    measure = @log10;
    tics = 10.^(ceil (log10 (range(1)) - 1e-9):log10 (range(2)) + 1e-9);
  else
    step = tic_step (range, 5);
    tics = step*(ceil (range(1)/step - 1e-9):range(2)/step + 1e-9);
  endif
  part = @(x) (measure (x) - measure (range(1)))/(measure (range(2)) - measure (range(1)));
  if (isempty (words))
    words = arrayfun (@(x) sprintf ("%.6g", x), tics, "uniformoutput", false);
  endif
  axis = struct ("range", range, "part", part, "tics", part (tics), "texts", {words});
endfunction

## a line a row, through as many axes as there are columns, and its colour
function table = polylines (parts, colour)
  [count, axes] = size (parts);
  [k, j] = ndgrid ([1:axes, NaN], 1:count);
  table = [k(:), [parts, NaN(count, 1)].'(:), colour(:)(j(:))(:)];
endfunction

%!function missing = drawn (folder, sweep)
%!  draw = @(scratch) draw_parallel (sweep, "it's a \"rod\"", scratch);
%!  missing = draw_files (folder, {draw}, {"sweep.svg", "sweep.png"});
%!endfunction
%!test # with words, over decades, with one that failed, or none; where nothing differs
%! x = [1:6; 10.^(0:5); 1 2 1 2 1 2].';
%! sweep = struct ("x", x, "names", {{"a_b", "c", "solver"}}, "words", {{{}, {}, {"rk4", "it's"}}}, ...
%!                 "y", [NaN(6, 1), [1:5, NaN].'], "texts", {{"model", "max|y| [m]"}}, "failed", [false(1, 5), true]);
%! loose = sweep; loose.failed(6) = false; loose.y(:,2) = 7;
%! for each = {sweep, loose}
%!   assert (in_scratch (@(folder, scratch) drawn (folder, each{1})), cell (0, 2));
%! endfor
%!function text = drawn_settings (scratch, sweep)
%!  finish_tool (draw_parallel (sweep, "", scratch));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # what does not differ stands in the middle of its axis
%! sweep = struct ("x", [1 2 3; 4 5 6], "names", {{"a", "b", "c"}}, "words", {{{}, {}, {}}}, "y", [0; 0], ...
%!                 "texts", {{"y"}}, "failed", [false false]);
%! text = in_scratch (@(folder, scratch) drawn_settings (scratch, sweep));
%! assert (! isempty (strfind (text, sprintf ("c_low = -0.5\nc_high = 0.5\n"))), text);
