## -*- texinfo -*-
## @deftypefn {} {@var{name} =} value_name (@var{what})
## What messages call the value of a joint: "joints(2).value" of @var{what} = joints(2), and moment itself of "moment",
## which a scene of one rod has in short.
## @end deftypefn

function name = value_name (what)
  prefix = field_prefix (what);
  name = what;
  if (! isempty (prefix))
    name = [prefix "value"];
  endif
endfunction

%!assert ({value_name("joints(2)"), value_name("moment")}, {"joints(2).value", "moment"})
