## -*- texinfo -*-
## @deftypefn {} {@var{text} =} labelled_points (@var{name}, @var{rows})
## A named data block of gnuplot with the seconds, the error (m) and the label of @var{rows} of @code{model_ladder}, one
## without any where there are none.
## @end deftypefn

function text = labelled_points (name, rows)
  lines = {"NaN NaN \"\"\n"};
  if (! isempty (rows))
    lines = arrayfun (@(row) sprintf ("%.9g %.9g \"%s\"\n", row.seconds, row.error_m, row.label), rows, ...
                      "uniformoutput", false);
  endif
  text = ["$" name " << EOD\n" lines{:} "EOD\n"];
endfunction

%!assert (labelled_points ("a", []), "$a << EOD\nNaN NaN \"\"\nEOD\n")
%!test
%! rows = struct ("seconds", {1, 2.5}, "error_m", {1e-3, 0.1}, "label", {"3+1", ""});
%! assert (labelled_points ("b", rows), "$b << EOD\n1 0.001 \"3+1\"\n2.5 0.1 \"\"\nEOD\n");
