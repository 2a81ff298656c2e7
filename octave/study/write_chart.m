## -*- texinfo -*-
## @deftypefn {} {} write_chart (@var{table}, @var{ladder}, @var{cost}, @var{scene}, @var{folder})
## The @var{table} of @code{work_precision} as chart.csv, and with the @var{ladder} of models and the @var{cost} of
## @code{cost_of_size} as chart.svg and chart.png; the cost as cost.csv.
## @end deftypefn

function write_chart (table, ladder, cost, scene, folder)
  lines = {"method,tolerance [m] or step [s],tip error [m],phi error [rad],seconds [s],calls,extrapolated,failure"};
  for row = table
    lines{end+1} = sprintf ("%s,%.17g,%.17g,%.17g,%.17g,%d,%d,\"%s\"", row.method, row.parameter, row.tip_error, ...
                            row.phi_error, row.seconds, row.calls, row.extrapolated, row.failure);
  endfor
  write_text (fullfile (folder, "chart.csv"), [strjoin(lines, "\n") "\n"]);
  write_text (fullfile (folder, "cost.csv"), ...
              ["modes N + N,seconds per simulated second,calls per simulated second\n", ...
               sprintf("%d,%.17g,%.17g\n", cost.')]);

  scratch = fullfile (folder, "scratch");
  mkdir (scratch);
  methods = unique ({table.method}, "stable");
  text = gnuplot_settings (struct ("title", sprintf ("%s, %d + %d sines", scene.title, scene.model.modes), ...
                                   "methods", {methods}, "cost_low", cost(1,2)));
  for k = 1:numel (methods)
    of_method = table(strcmp ({table.method}, methods{k}));
    failed = ! cellfun (@isempty, {of_method.failure});
    text = [text, block(sprintf ("curve_%d", k), of_method(! failed)), ...
            block(sprintf ("part_%d", k), of_method([of_method.extrapolated] & ! failed)), ...
            block(sprintf ("failed_%d", k), of_method(failed))];
  endfor
  rows = ladder([ladder.error_m] > 0 & isfinite ([ladder.error_m]));
  chosen = rows([rows.chosen]);
  write_text (fullfile (scratch, "settings.gp"), [text, gnuplot_block("cost", {cost}), ...
                                                  ladder_block("ladder", rows), ladder_block("chosen", chosen)]);
  finish_tool (start_gnuplot (scratch, "chart.gp"));
  confirm_recursive_rmdir (false, "local");
  rmdir (scratch, "s");
endfunction

## seconds, calls, the larger of both errors; what failed stands at the top
function text = block (name, rows)
  text = sprintf ("$%s << EOD\n", name);
  for row = rows
    error = max (row.tip_error, row.phi_error);
    if (! isempty (row.failure) || ! isfinite (error) || error > 1)
      error = 1;
    endif
    text = [text, sprintf("%.9g %d %.9g\n", row.seconds, max (row.calls, 1), error)];
  endfor
  text = [text, repmat("NaN NaN NaN\n", 1, isempty (rows)), "EOD\n"];
endfunction

## named are those that no other is both faster and better than, where no name is near
function text = ladder_block (name, rows)
  for k = 1:numel (rows)
    if (any ([rows.seconds] < rows(k).seconds & [rows.error_m] < rows(k).error_m))
      rows(k).label = "";
    endif
  endfor
  text = sprintf ("$%s << EOD\n", name);
  for row = spaced_labels (rows)
    text = [text, sprintf("%.9g %.9g \"%s\"\n", row.seconds, row.error_m, row.label)];
  endfor
  text = [text, repmat("NaN NaN \"\"\n", 1, isempty (rows)), "EOD\n"];
endfunction

%!test # a curve, a part of one and a failure
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   row = struct ("method", "rk4", "parameter", {1e-3 1e-4 1e-5}, "tip_error", {1e-3 1e-5 NaN}, ...
%!                 "phi_error", {1e-4 1e-5 NaN}, "seconds", {1 2 3}, "calls", {10 20 30}, ...
%!                 "extrapolated", {false true false}, "failure", {"", "", "rk4 stopped"});
%!   ladder = struct ("label", "3", "error_m", 1e-3, "seconds", 2, "chosen", true);
%!   write_chart (row, ladder, [2 0.1 100; 4 0.3 200], struct ("title", "rod", "model", struct ("modes", [7 7])), ...
%!                folder);
%!   assert (sort ({dir(folder).name}), {".", "..", "chart.csv", "chart.png", "chart.svg", "cost.csv"});
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
