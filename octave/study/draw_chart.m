## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_chart (@var{table}, @var{ladder}, @var{cost}, @var{notes}, @var{scratch})
## The @var{table} of @code{work_precision} with the @var{ladder} of models and the @var{cost} of @code{cost_of_size}
## (both may be empty), chart.svg and chart.png beside the folder @var{scratch}, which takes the data.  They are there
## when @var{job} has ended (see @code{finish_tool}).  The second panel has the calls, or the drift of constraints.
##
## @var{notes} is a struct of title, tolerance (m), auto (the method that "auto" takes) and floor (m: the reference's
## own error, NaN where it is not known).
## @end deftypefn

function job = draw_chart (table, ladder, cost, notes, scratch)
  methods = unique ({table.method}, "stable");
  drifts = any (isfinite ([table.drift]));
  chosen = rows = ladder;
  if (! isempty (ladder))
    rows = ladder([ladder.error_m] > 0 & isfinite ([ladder.error_m]));
    chosen = rows([rows.chosen]);
  endif
  floor = max ([notes.floor, 1e-16]);
  best = fastest_rows (table, max (notes.tolerance, floor));
  own = best(strcmp ({best.method}, notes.auto));
  text = gnuplot_settings (struct ("title", notes.title, "methods", {methods}, "drifts", double (drifts), ...
                                   "rungs", numel (rows), "sizes", size (cost, 1), "tolerance", notes.tolerance, ...
                                   "floor", floor, "cost_first", [cost(:,1:2); 1 1](1,:)));
  for k = 1:numel (methods)
    of_method = table(strcmp ({table.method}, methods{k}));
    failed = ! cellfun (@isempty, {of_method.failure});
    text = [text, block(sprintf ("curve_%d", k), of_method(! failed), drifts, floor), ...
            block(sprintf ("part_%d", k), of_method([of_method.part] < 1 & ! failed), drifts, floor), ...
            block(sprintf ("failed_%d", k), of_method(failed), drifts, floor)];
  endfor
  text = [text, block("own", own, drifts, floor), gnuplot_block("cost", {[cost; NaN NaN NaN](1:max (end-1, 1),:)}), ...
          ladder_block("ladder", rows), ladder_block("chosen", chosen)];
  write_text (fullfile (scratch, "settings.gp"), text);
  job = start_gnuplot (scratch, "chart.gp");
endfunction

## seconds and error, and what the second panel has; what failed stands at the top
function text = block (name, rows, drifts, floor)
  text = sprintf ("$%s << EOD\n", name);
  for row = rows
    error = max ([row.error_m, floor]);  # nearer is not known
    if (! isempty (row.failure) || ! isfinite (error) || error > 1)
      error = 1;
    endif
    beside = [row.calls, error];
    beside(row.calls == 0) = NaN;  # it failed before
    if (drifts)
      beside = [row.seconds, row.drift + 1e-17];
    endif
    text = [text, sprintf("%.9g %.9g %.9g %.9g\n", row.seconds, error, beside)];
  endfor
  if (isempty (rows))
    text = [text, "NaN NaN NaN NaN\n"];
  endif
  text = [text, "EOD\n"];
endfunction

## named are those that no other is both faster and better than, where no name is near
function text = ladder_block (name, rows)
  for k = 1:numel (rows)
    if (any ([rows.seconds] < rows(k).seconds & [rows.error_m] < rows(k).error_m))
      rows(k).label = "";
    endif
  endfor
  if (! isempty (rows))
    rows = spaced_labels (rows);
  endif
  text = labelled_points (name, rows);
endfunction

%!test # a curve, a part of one and a failure; constraints that drift, and no ladder
%! row = struct ("method", "rk4", "parameter", {1e-3 1e-4 1e-5}, "error_m", {1e-3 1e-5 NaN}, "drift", NaN, ...
%!               "seconds", {1 2 3}, "calls", {10 20 30}, "part", {1 0.5 1}, ...
%!               "failure", {"", "", "rk4 stopped"});
%! ladder = struct ("label", "3", "error_m", 1e-3, "seconds", 2, "chosen", true);
%! notes = struct ("title", "it's a \"rod\"", "tolerance", 1e-4, "auto", "rk4", "floor", NaN);
%! drifting = row;
%! [drifting.drift] = deal (1e-6, 0, 1e-3);
%! for given = {{row, ladder, [2 0.1 100; 4 0.3 200]}, {drifting, struct([]), zeros(0, 3)}}
%!   [folder, gone] = scratch_folder ();
%!   draw = {@(scratch) draw_chart(given{1}{:}, notes, scratch)};
%!   assert (draw_files (folder, draw, {"chart.svg", "chart.png"}), cell (0, 2));
%! endfor
%!function text = settings_of (varargin)
%!  scratch = varargin{end};
%!  finish_tool (draw_chart (varargin{:}));
%!  text = fileread (fullfile (scratch, "settings.gp"));
%!endfunction
%!test # a failure stands at the top, an error of 0 at the bottom; labels are those that no other is better than
%! row = struct ("method", {"rk4" "rk4" "rk4" "gauss" "gauss" "gauss"}, "error_m", {1e-3 1e-5 NaN 0 7 0.9}, ...
%!               "drift", NaN, ...
%!               "seconds", {1 2 3 4 5 6}, "calls", {10 20 0 40 50 60}, ...
%!               "part", {1 0.5 0.5 1 1 1}, ...
%!               "failure", {"", "", "rk4 stopped", "", "", ""});
%! ladder = struct ("label", {"1", "3", "5", "7"}, "error_m", {1e-2, 1e-3, 2e-3, 0}, "seconds", {1 2 4 8}, ...
%!                  "chosen", {false, true, false, false});
%! notes = struct ("title", "A rod", "tolerance", 1e-4, "auto", "rk4", "floor", NaN);
%! cost = [2 0.1 100; 4 0.3 200];
%! in = @(table, ladder) in_scratch (@(folder, scratch) settings_of (table, ladder, cost, notes, scratch));
%! text = in (row, ladder);
%! for part = {"title = 'A rod'", "array methods[2] = ['rk4', 'gauss']", "drifts = 0", "rungs = 3", ...
%!             "cost_first_low = 2", ...
%!             "cost_first_high = 0.1", "$curve_1 << EOD\n1 0.001 10 0.001\n2 1e-05 20 1e-05\nEOD", ...
%!             "$part_1 << EOD\n2 1e-05 20 1e-05\nEOD", "$failed_1 << EOD\n3 1 NaN 1\nEOD", ...
%!             "$own << EOD\n2 1e-05 20 1e-05\nEOD", ...
%!             "$curve_2 << EOD\n4 1e-16 40 1e-16\n5 1 50 1\n6 0.9 60 0.9\nEOD", ...
%!             "$part_2 << EOD\nNaN NaN NaN NaN\nEOD", "$failed_2 << EOD\nNaN NaN NaN NaN\nEOD", ...
%!             "$cost << END\n2 0.1 100 \n4 0.3 200 \nEND", ...
%!             "$ladder << EOD\n1 0.01 \"1\"\n2 0.001 \"3\"\n4 0.002 \"\"\nEOD", ...
%!             "$chosen << EOD\n2 0.001 \"3\"\nEOD"}
%!   assert (numel (strfind (text, [part{1} "\n"])) == 1, "%s", part{1});
%! endfor
%! [row.drift] = deal (1e-6, 0, NaN, 1e-3, 1, 1);
%! text = in (row(1:2), struct ([]));
%! for part = {"drifts = 1", "rungs = 0", "$curve_1 << EOD\n1 0.001 1 1e-06\n2 1e-05 2 1e-17\nEOD", ...
%!             "$ladder << EOD\nNaN NaN \"\"\nEOD"}
%!   assert (numel (strfind (text, [part{1} "\n"])) == 1, "%s", part{1});
%! endfor
