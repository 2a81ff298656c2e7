## -*- texinfo -*-
## @deftypefn {} {} write_history (@var{names}, @var{table}, @var{file})
## A history as CSV: a header of @var{names} with units (a cellstr), and the @var{table} (names-by-times), a line a
## time with 17 significant digits.
## @end deftypefn

function write_history (names, table, file)
  lines = sprintf ([repmat("%.17g,", 1, rows (table) - 1), "%.17g\n"], table);
  write_text (file, [strjoin(names, ","), "\n", lines]);
endfunction

%!test
%! [folder, gone] = scratch_folder (); file = fullfile (folder, "a");
%! write_history ({"t [s]", "V2_1 [m]"}, [0 0.1; pi 2], file);
%! text = fileread (file);
%! assert (strncmp (text, "t [s],V2_1 [m]\n", 15));
%! assert (csvread (file, 1, 0), [0 pi; 0.1 2]);
