## -*- texinfo -*-
## @deftypefn {} {} write_chart (@var{table}, @var{cost}, @var{title}, @var{words}, @var{folder})
## The @var{table} of @code{work_precision} as chart.csv, the @var{cost} of @code{cost_of_size} as cost.csv, and the
## @var{words} of @code{chart_words} under the scene's @var{title} as chart.md.
## @end deftypefn

function write_chart (table, cost, title, words, folder)
  heads = {"method", "tolerance [m] or step [s]", "error [m]", "drift [m or rad]", "seconds [s]", "calls", ...
           "part of the duration", "failure"};
  part = cellfun (@(part) sprintf ("%.6g", part), {table.part}, "uniformoutput", false);
  cells = [{table.method}; {table.parameter}; {table.error_m}; {table.drift}; {table.seconds}; {table.calls}; ...
           part; {table.failure}].';
  write_csv (fullfile (folder, "chart.csv"), heads, cells, 8);
  write_text (fullfile (folder, "chart.md"), sprintf ("# %s\n\n%s\n", title, words));
  write_csv (fullfile (folder, "cost.csv"), ...
             {"modes of each sort", "seconds per simulated second", "calls per simulated second"}, cost);
endfunction

%!test # a whole run, a part of one and a failure
%! [folder, gone] = scratch_folder ();
%! row = struct ("method", "rk4", "parameter", {1e-3 1e-4 1e-5}, "error_m", {1e-3 1e-5 NaN}, ...
%!               "drift", {1e-4 1e-5 NaN}, "seconds", {1 2 3}, "calls", {10 20 30}, ...
%!               "part", {1 0.25 1}, "failure", {"", "", "rk4 stopped"});
%! write_chart (row, [2 0.1 100; 4 0.3 200], "A rod", "It is fast.", folder);
%! lines = strsplit (fileread (fullfile (folder, "chart.csv")), "\n");
%! assert (lines{3}, "rk4,0.0001,1.0000000000000001e-05,1.0000000000000001e-05,2,20,0.25,\"\"");
%! assert (lines{4}, "rk4,1.0000000000000001e-05,NaN,NaN,3,30,1,\"rk4 stopped\"");
%! assert (csvread (fullfile (folder, "cost.csv"), 1, 0), [2 0.1 100; 4 0.3 200]);
%! assert (fileread (fullfile (folder, "chart.md")), "# A rod\n\nIt is fast.\n");
