## -*- texinfo -*-
## @deftypefn {} {} write_ladder (@var{table}, @var{folder})
## The @var{table} of @code{model_ladder} as models.csv.
## @end deftypefn

function write_ladder (table, folder)
  heads = {"model", "method", "error [m]", "seconds [s]", "calls", "chosen", "part of the duration"};
  part = cellfun (@(part) sprintf ("%.6g", part), {table.part}, "uniformoutput", false);
  cells = [{table.model}; {table.method}; {table.error_m}; {table.seconds}; {table.calls}; {table.chosen}; part].';
  write_csv (fullfile (folder, "models.csv"), heads, cells, 1);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! write_ladder (struct ("model", "3 bending modes, foreshortening", "method", "exponential", "error_m", 1e-3, ...
%!                       "seconds", 2, "calls", 7, "chosen", true, "part", 0.5), folder);
%! lines = strsplit (fileread (fullfile (folder, "models.csv")), "\n");
%! assert (lines{2}, "\"3 bending modes, foreshortening\",exponential,0.001,2,7,1,0.5");
