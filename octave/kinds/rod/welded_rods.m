## -*- texinfo -*-
## @deftypefn {} {@var{text} =} welded_rods ()
## What to take instead of a rod that bends too much for its model, to say in a warning.
## @end deftypefn

function text = welded_rods ()
  text = "several shorter rods welded together (scene.bodies, joints of the kind \"weld\") bend less each";
endfunction

%!assert (! isempty (strfind (welded_rods (), "weld")))
