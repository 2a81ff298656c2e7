## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_chart (@var{table}, @var{ladder}, @var{cost}, @var{scene}, @var{scratch})
## The @var{table} of @code{work_precision} with the @var{ladder} of models and the @var{cost} of @code{cost_of_size},
## chart.svg and chart.png beside the folder @var{scratch}, which takes the data.  They are there when @var{job} has
## ended (see @code{finish_tool}).
## @end deftypefn

function job = draw_chart (table, ladder, cost, scene, scratch)
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
  job = start_gnuplot (scratch, "chart.gp");
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
%!   scene = struct ("title", "it's a \"rod\"", "model", struct ("modes", [7 7]));
%!   draw = {@(scratch) draw_chart(row, ladder, [2 0.1 100; 4 0.3 200], scene, scratch)};
%!   assert (draw_files (folder, draw, {"chart.svg", "chart.png"}), cell (0, 2));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
