## -*- texinfo -*-
## @deftypefn {} {} write_constrained_chart (@var{table}, @var{cost}, @var{folder})
## The @var{table} of @code{constrained_precision} as chart.csv, and the @var{cost} of @code{chain_cost} as cost.csv.
## @end deftypefn

function write_constrained_chart (table, cost, folder)
  lines = {"method,tolerance [m] or step [s],error [m],drift [m or rad],seconds [s],calls,failure"};
  for row = table
    lines{end+1} = sprintf ("%s,%.17g,%.17g,%.17g,%.17g,%d,\"%s\"", row.method, row.parameter, row.error, ...
                            row.drift, row.seconds, row.calls, row.failure);
  endfor
  write_text (fullfile (folder, "chart.csv"), [strjoin(lines, "\n") "\n"]);
  write_text (fullfile (folder, "cost.csv"), ["rods,seconds per simulated second,steps\n", ...
                                              sprintf("%d,%.17g,%d\n", cost.')]);
endfunction

%!test
%! folder = tempname (); mkdir (folder); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   row = struct ("method", "radau", "parameter", {1e-3 1e-4}, "error", {1e-3 1e-5}, "drift", {0 1e-15}, ...
%!                 "seconds", {1 2}, "calls", {10 20}, "failure", "");
%!   write_constrained_chart (row, [1 0.1 10; 2 0.3 20], folder);
%!   lines = strsplit (fileread (fullfile (folder, "chart.csv")), "\n");
%!   assert (lines{2}, "radau,0.001,0.001,0,1,10,\"\"");
%!   assert (csvread (fullfile (folder, "cost.csv"), 1, 0), [1 0.1 10; 2 0.3 20]);
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
