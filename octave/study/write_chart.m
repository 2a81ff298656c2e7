## -*- texinfo -*-
## @deftypefn {} {} write_chart (@var{table}, @var{cost}, @var{folder})
## The @var{table} of @code{work_precision} as chart.csv, and the @var{cost} of @code{cost_of_size} as cost.csv.
## @end deftypefn

function write_chart (table, cost, folder)
  lines = {"method,tolerance [m] or step [s],error [m],drift [m or rad],seconds [s],calls,extrapolated,failure"};
  for row = table
    lines{end+1} = sprintf ("%s,%.17g,%.17g,%.17g,%.17g,%d,%d,\"%s\"", row.method, row.parameter, row.error_m, ...
                            row.drift, row.seconds, row.calls, row.extrapolated, strrep (row.failure, "\"", "\"\""));
  endfor
  write_text (fullfile (folder, "chart.csv"), [strjoin(lines, "\n") "\n"]);
  write_text (fullfile (folder, "cost.csv"), ...
              ["modes of each sort,seconds per simulated second,calls per simulated second\n", ...
               sprintf("%d,%.17g,%.17g\n", cost.')]);
endfunction

%!test # a whole run, a part of one and a failure
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   row = struct ("method", "rk4", "parameter", {1e-3 1e-4 1e-5}, "error_m", {1e-3 1e-5 NaN}, ...
%!                 "drift", {1e-4 1e-5 NaN}, "seconds", {1 2 3}, "calls", {10 20 30}, ...
%!                 "extrapolated", {false true false}, "failure", {"", "", "rk4 stopped"});
%!   write_chart (row, [2 0.1 100; 4 0.3 200], folder);
%!   lines = strsplit (fileread (fullfile (folder, "chart.csv")), "\n");
%!   assert (lines{4}, "rk4,1.0000000000000001e-05,NaN,NaN,3,30,0,\"rk4 stopped\"");
%!   assert (csvread (fullfile (folder, "cost.csv"), 1, 0), [2 0.1 100; 4 0.3 200]);
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
