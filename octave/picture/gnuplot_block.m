## -*- texinfo -*-
## @deftypefn {} {@var{text} =} gnuplot_block (@var{name}, @var{blocks})
## A named data block of gnuplot. Each matrix of the cell array @var{blocks} has an index there; a row of NaN lifts the
## pen, and so does a matrix without rows.
## @end deftypefn

function text = gnuplot_block (name, blocks)
  parts = cellfun (@matrix_text, blocks, "UniformOutput", false);
  text = sprintf ("$%s << END\n%sEND\n", name, strjoin (parts, "\n\n"));
endfunction

function text = matrix_text (matrix)
  if (isempty (matrix))
    matrix = NaN (1, columns (matrix));
  endif
  text = sprintf ([repmat("%.7g ", 1, columns (matrix)) "\n"], matrix.');
  text = regexprep (text, '^NaN .*$', "", "lineanchors", "dotexceptnewline");
endfunction

%!assert (gnuplot_block ("a", {[1 2; NaN NaN; 3 4], 5}), "$a << END\n1 2 \n\n3 4 \n\n\n5 \nEND\n")
