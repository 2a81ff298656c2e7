## -*- texinfo -*-
## @deftypefn {} {@var{text} =} exact_instead ()
## What to take instead of a rod whose models drop too much against the geometrically exact one, to say in a warning.
## @end deftypefn

function text = exact_instead ()
  text = "EXACT=yes, or the option \"exact\", takes the geometrically exact rod";
endfunction

%!assert (strncmp (exact_instead (), "EXACT=yes", 9))
