## -*- texinfo -*-
## @deftypefn {} {} write_ladder (@var{table}, @var{folder})
## The @var{table} of @code{model_ladder} as models.csv.
## @end deftypefn

function write_ladder (table, folder)
  lines = {"model,method,error [m],seconds [s],calls,chosen,part of the duration"};
  for row = table
    lines{end+1} = sprintf ("\"%s\",%s,%.17g,%.17g,%d,%d,%.6g", row.model, row.method, row.error_m, row.seconds, ...
                            row.calls, row.chosen, row.part);
  endfor
  write_text (fullfile (folder, "models.csv"), [strjoin(lines, "\n") "\n"]);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! write_ladder (struct ("model", "3 bending modes, foreshortening", "method", "exponential", "error_m", 1e-3, ...
%!                       "seconds", 2, "calls", 7, "chosen", true, "part", 0.5), folder);
%! lines = strsplit (fileread (fullfile (folder, "models.csv")), "\n");
%! assert (lines{2}, "\"3 bending modes, foreshortening\",exponential,0.001,2,7,1,0.5");
