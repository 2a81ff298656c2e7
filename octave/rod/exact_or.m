## -*- texinfo -*-
## @deftypefn {} {@var{text} =} exact_or (@var{exact}, @var{other})
## What to take instead of rods whose models drop too much, to say in a warning: the @var{exact} scene where there is
## one, and else the @var{other} text, by default that rods be welded of pieces.
## @end deftypefn

function text = exact_or (exact, other = welded ())
  text = "EXACT=yes, or the option \"exact\", takes the geometrically exact rod";
  if (isempty (exact))
    text = other;
  endif
endfunction

function text = welded ()
  text = "PIECES=4, or the option \"pieces\", makes each rod of as many shorter rods welded together, which bend less";
endfunction

%!assert (strncmp (exact_or (paper ()), "EXACT=yes", 9))
%!assert (! isempty (strfind (exact_or ([]), "weld")))
%!assert (exact_or ([], "stay at home"), "stay at home")
