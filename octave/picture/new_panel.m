## -*- texinfo -*-
## @deftypefn {} {@var{panel} =} new_panel (@var{label}, @var{unit}, @var{names}, @var{values})
## Curves over the frames' times that stand in one panel of a picture, as a struct of its arguments:
## @var{label} (text), @var{unit} (of the values, without prefix; "" for none), @var{names} (1-by-n cellstr)
## and @var{values} (n-by-F).
## @end deftypefn

function panel = new_panel (label, unit, names, values)
  panel = struct ("label", label, "unit", unit, "names", {names}, "values", values);
endfunction

%!assert (new_panel ("a", "m", {"b", "c"}, [1; 2]).names, {"b", "c"})
