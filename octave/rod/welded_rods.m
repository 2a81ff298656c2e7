## -*- texinfo -*-
## @deftypefn {} {@var{text} =} welded_rods ()
## What to take instead of a rod that bends too much for its model, to say in a warning.
## @end deftypefn

function text = welded_rods ()
  text = "PIECES=4, or the option \"pieces\", makes each rod of as many shorter rods welded together, which bend less";
endfunction

%!assert (! isempty (strfind (welded_rods (), "weld")))
