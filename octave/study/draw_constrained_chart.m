## -*- texinfo -*-
## @deftypefn {} {@var{job} =} draw_constrained_chart (@var{table}, @var{cost}, @var{scene}, @var{scratch})
## The @var{table} of @code{constrained_precision} and the @var{cost} of @code{chain_cost}, chart.svg and chart.png
## beside the folder @var{scratch}, which takes the data.  They are there when @var{job} has ended (see
## @code{finish_tool}).
## @end deftypefn

function job = draw_constrained_chart (table, cost, scene, scratch)
  methods = unique ({table.method}, "stable");
  text = gnuplot_settings (struct ("title", scene.title, "methods", {methods}));
  for k = 1:numel (methods)
    own = table(strcmp ({table.method}, methods{k}));
    text = [text, gnuplot_block(sprintf ("curve_%d", k), {[[own.seconds]; [own.error]; max([own.drift], 1e-17)].'})];
  endfor
  write_text (fullfile (scratch, "settings.gp"), [text, gnuplot_block("cost", {cost})]);
  job = start_gnuplot (scratch, "constrained_chart.gp");
endfunction

%!test
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   row = struct ("method", "radau", "parameter", {1e-3 1e-4}, "error", {1e-3 1e-5}, "drift", {0 1e-15}, ...
%!                 "seconds", {1 2}, "calls", {10 20}, "failure", "");
%!   scene = struct ("title", "it's an \"arm\"");
%!   draw = {@(scratch) draw_constrained_chart(row, [1 0.1 10; 2 0.3 20], scene, scratch)};
%!   assert (draw_files (folder, draw, {"chart.svg", "chart.png"}), cell (0, 2));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
