## -*- texinfo -*-
## @deftypefn {} {} write_stability (@var{table}, @var{folder})
## The @var{table} of @code{stability} as stability.csv.
## @end deftypefn

function write_stability (table, folder)
  lines = {"method,what,predicted,measured"};
  for row = table
    lines{end+1} = sprintf ("\"%s\",\"%s\",%.17g,%.17g", row.method, row.what, row.predicted, row.measured);
  endfor
  write_text (fullfile (folder, "stability.csv"), [strjoin(lines, "\n") "\n"]);
endfunction

%!test
%! [folder, gone] = scratch_folder ();
%! write_stability (struct ("method", "rk4", "what", "limit", "predicted", 2.5, "measured", 2.8), folder);
%! text = fileread (fullfile (folder, "stability.csv"));
%! assert (text, "method,what,predicted,measured\n\"rk4\",\"limit\",2.5,2.7999999999999998\n");
