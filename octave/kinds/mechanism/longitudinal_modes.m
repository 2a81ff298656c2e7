## -*- texinfo -*-
## @deftypefn {} {@var{count} =} longitudinal_modes (@var{levels})
## How many longitudinal modes the rods of a mechanism have beside bending modes of these @var{levels} (1-by-bodies):
## one for every two beyond the first.
## @end deftypefn

function count = longitudinal_modes (levels)
  count = max (0, floor ((levels - 1)/2));
endfunction

%!assert (longitudinal_modes ([0 1 2 3 4 5]), [0 0 0 1 1 2])
