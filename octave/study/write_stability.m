## -*- texinfo -*-
## @deftypefn {} {} write_stability (@var{table}, @var{folder})
## The @var{table} of @code{stability} as stability.csv.
## @end deftypefn

function write_stability (table, folder)
  cells = [{table.method}; {table.what}; {table.predicted}; {table.measured}].';
  write_csv (fullfile (folder, "stability.csv"), {"method", "what", "predicted", "measured"}, cells, [1 2]);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! write_stability (struct ("method", "rk4", "what", "limit of \"a\"", "predicted", 2.5, "measured", 2.8), folder);
%! text = fileread (fullfile (folder, "stability.csv"));
%! assert (text, "method,what,predicted,measured\n\"rk4\",\"limit of \"\"a\"\"\",2.5,2.7999999999999998\n");
