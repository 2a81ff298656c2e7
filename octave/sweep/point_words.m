## -*- texinfo -*-
## @deftypefn {} {@var{text} =} point_words (@var{columns}, @var{values})
## A point of a sweep as AT takes it: "rod.length=0.2; solver.name=rk4".
## @end deftypefn

function text = point_words (columns, values)
  words = cellfun (@(name, value) [name "=" value_words(value)], columns, values, "uniformoutput", false);
  text = strjoin (words, "; ");
endfunction

%!assert (point_words ({"rod.length", "solver.name", "model.modes"}, {0.2, "rk4", [0 4]}), ...
%!        "rod.length=0.2; solver.name=rk4; model.modes=0 4")
