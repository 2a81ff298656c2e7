## -*- texinfo -*-
## @deftypefn {} {@var{loads} =} load_list (@var{rows})
## The loads and prescribed motions of a scene that are functions of time: a struct array of the @var{rows} (a cell
## array), without those whose second entry is a number or empty, which neither jump nor fail.  A row has
##
## @table @code
## @item name
## as the scene has it: "moment", "rotation", "joints(2).value"
## @item at
## the function of t (s)
## @item numbers
## how many numbers it returns
## @item takes
## what these should be, for messages
## @item prescribed
## which of them are places or their rates, that cannot jump
## @item vectorised
## true where it takes many t at once and returns a number for each
## @end table
## @end deftypefn

function loads = load_list (rows)
  functions = cellfun (@is_function_handle, rows(:,2));
  loads = cell2struct (rows(functions,:), {"name", "at", "numbers", "takes", "prescribed", "vectorised"}, 2).';
endfunction

%!test # numbers are left out
%! loads = load_list ({"moment", 3, 1, "a number", [], true; "force", @(t) [t 0], 2, "2 numbers", [], false});
%! assert ({loads.name}, {"force"}); assert (loads.at (2), [2 0]);
%!assert (size (load_list ({"moment", 3, 1, "a number", [], true})), [1 0])
