## -*- texinfo -*-
## @deftypefn {} {[@var{columns}, @var{values}] =} sweep_table (@var{settings})
## The points of a sweep by its @var{settings} (see @code{sweep_settings}), of which vary, zip, over, table and at each
## make a table: the names of its @var{columns}, and a cell array of @var{values}, a row a point.
## @end deftypefn

function [columns, values] = sweep_table (settings)
  makers = {"vary", @() combined(settings); "zip", @() side_by_side(settings.zip)
            "over", @() read_points(user_path (settings.over)); "at", @() one_point(settings.at)
            "table", @() of_cells(settings.table)};
  asked = cellfun (@(name) ! isempty (settings.(name)), makers(:,1));
  if (sum (asked) != 1)
    scene_error ("a sweep takes one of VARY, ZIP and OVER: here are %d of them", sum (asked));
  elseif (! isempty (settings.random) && ! asked(1))
    scene_error ("RANDOM takes its ranges from VARY, as in VARY=\"rod.length=0.2..1\"");
  endif
  [columns, values] = makers{asked,2} ();
endfunction

function [columns, values] = combined (settings)
  [columns, lists] = read_vary (settings.vary, "VARY");
  ranges = cellfun (@(list) isstruct (list{1}), lists);
  if (! isempty (settings.random))
    if (! all (ranges))
      scene_error ("VARY: RANDOM takes a range, %s=0.2..1 say", columns{find (! ranges, 1)});
    endif
    values = num2cell (latin_hypercube (cellfun (@(list) list{1}, lists), settings.random, settings.seed));
    return;
  endif
  refuse_ranges (columns, ranges, "VARY");
  values = every_combination (lists);
endfunction

## the last column changes first
function values = every_combination (lists)
  counts = cellfun (@numel, lists);
  if (prod (counts) > 1e5)
    scene_error ("VARY: %g combinations are more than 100000", prod (counts));
  endif
  values = cell (prod (counts), numel (lists));
  for k = 1:numel (lists)
    index = repmat (repelem (1:counts(k), prod (counts(k+1:end))), 1, prod (counts(1:k-1)));
    values(:,k) = lists{k}(index);
  endfor
endfunction

function [columns, values] = side_by_side (text)
  [columns, lists] = read_vary (text, "ZIP");
  refuse_ranges (columns, cellfun (@(list) isstruct (list{1}), lists), "ZIP");
  counts = cellfun (@numel, lists);
  odd = find (counts != counts(1), 1);
  if (! isempty (odd))
    scene_error ("ZIP: %s has %d values and %s has %d: side by side they are as many", columns{1}, counts(1), ...
                 columns{odd}, counts(odd));
  endif
  values = vertcat (lists{:}).';
endfunction

function [columns, values] = one_point (text)
  [columns, lists] = read_vary (text, "AT");
  refuse_ranges (columns, cellfun (@(list) isstruct (list{1}), lists), "AT");
  counts = cellfun (@numel, lists);
  if (any (counts != 1))
    k = find (counts != 1, 1);
    scene_error ("AT: %s has %d values: one point takes one of each field", columns{k}, counts(k));
  endif
  values = [lists{:}];
endfunction

## numbers and texts pass through what a table in a file may hold
function [columns, values] = of_cells (table)
  if (! (ndims (table) == 2 && rows (table) > 1 && iscellstr (table(1,:))))
    scene_error ("table is a %d-by-%d cell: it takes a row of names and a row a point", size (table));
  endif
  columns = read_columns (table(1,:), "table");
  values = table(2:end,:);
  for k = 1:numel (values)
    [row, column] = ind2sub (size (values), k);
    where = sprintf ("table, row %d, %s", row + 1, columns{column});
    if (! (ischar (values{k}) || (isnumeric (values{k}) && isreal (values{k}))))
      scene_error ("%s is a %s: it takes numbers or a word", where, class (values{k}));
    endif
    values{k} = read_value (value_words (values{k}), where);
  endfor
endfunction

function refuse_ranges (columns, ranges, where)
  if (any (ranges))
    scene_error ("%s: %s is a range, which takes RANDOM=200, so many points", where, columns{find (ranges, 1)});
  endif
endfunction

%!function [columns, values] = table (varargin)
%!  [columns, values] = sweep_table (take_settings (varargin));
%!endfunction
%!test
%! [columns, values] = table ("vary", "a=1,2; b=x,y,z");
%! assert (columns, {"a", "b"});
%! assert (values, {1 "x"; 1 "y"; 1 "z"; 2 "x"; 2 "y"; 2 "z"});
%!assert (nthargout (2, @table, "zip", "a=1,2; b=3,4"), {1 3; 2 4})
%!assert (nthargout (2, @table, "at", "a=1; b=0 4"), {1, [0 4]})
%!test # a point in each of the parts of a range, the same for the same seed
%! [columns, values] = table ("vary", "a=0..1; b=10..20", "random", 50, "seed", 3);
%! x = cell2mat (values);
%! assert (sort (floor (50*x(:,1))), (0:49).'); assert (sort (floor (5*x(:,2))), (50:99).');
%! assert (nthargout (2, @table, "vary", "a=0..1; b=10..20", "random", 50, "seed", 3), values);
%! assert (! isequal (nthargout (2, @table, "vary", "a=0..1; b=10..20", "random", 50), values));
%!test
%! assert (nthargout (1:2, @table, "table", {"a", "b"; 0.1, "x"; [0 4], "y"}), {{"a", "b"}, {0.1 "x"; [0 4] "y"}});
%!error <table is a 1-by-2 cell: it takes a row of names and a row a point> table ("table", {"a", "b"})
%!error <table, row 2, a is a cell: it takes numbers or a word> table ("table", {"a"; {1}})
%!error <table, row 3, a is "../x": it takes a number> table ("table", {"a"; 1; "../x"})
%!error <table, row 2, a is "NaN"|table, row 2, a is .*: it takes> table ("table", {"a"; {}})
%!error <a sweep takes one of VARY, ZIP and OVER: here are 0 of them> table ()
%!error <here are 2 of them> table ("vary", "a=1", "zip", "a=1")
%!error <RANDOM takes its ranges from VARY> table ("zip", "a=1", "random", 3)
%!error <VARY: RANDOM takes a range, b=0.2..1 say> table ("vary", "a=0..1; b=3", "random", 3)
%!error <VARY: a is a range, which takes RANDOM=200> table ("vary", "a=0..1")
%!error <AT: b has 2 values: one point takes one of each field> table ("at", "a=1; b=2,3")
%!error <AT: a is a range> table ("at", "a=0..1")
%!error <ZIP: a has 2 values and c has 1> table ("zip", "a=1,2; b=1,2; c=3")
%!error <VARY: 1.001e\+08 combinations are more> table ("vary", "a=0:1:1000; b=1:1:1e5")
