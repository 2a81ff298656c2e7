## -*- texinfo -*-
## @deftypefn {} {@var{numbers} =} moment_corrections (@var{stations}, @var{length})
## Numbers of the bending base functions (see @code{base_functions}) that a rod of the @var{length} (m) takes beside
## sines, which have no curvature at ends, where moments act at the @var{stations} (m): -1 for O, -2 for the tip.
## @end deftypefn

function numbers = moment_corrections (stations, length)
  numbers = [-1 -2]([any(stations == 0), any(stations == length)]);
endfunction

%!assert (moment_corrections ([2 1 0], 2), [-1 -2]);
%!assert (moment_corrections ([1 2], 2), -2);
%!assert (moment_corrections ([], 2), zeros (1, 0));
