## -*- texinfo -*-
## @deftypefn {} {@var{numbers} =} elongation_numbers (@var{stations}, @var{rod}, @var{section})
## Mode numbers of the longitudinal base functions that a @var{rod} (a checked scene's field) takes beside sines where
## forces act along it at the @var{stations} (m): -part for a station at part*length, the tip (-1) first.  Under a
## force at the end N sines are F*l/EA times 0.2/N off, with this one function a static force leaves nothing.
##
## A force within the rod makes the strain jump.  That has an infinite energy where the @var{section} has a GI (see
## @code{rod_section}), and no place between the points of a curved rod's quadrature: these take sines alone there.
## @end deftypefn

function numbers = elongation_numbers (stations, rod, section)
  numbers = reshape (unique (-stations/rod.length), 1, []);
  numbers(numbers == 0) = [];
  if (section.GI > 0 || ! isempty (rod.curvature))
    numbers(numbers > -1) = [];
  endif
endfunction

%!test
%! rod = struct ("length", 2, "curvature", []);
%! assert (elongation_numbers ([0 1 2 1], rod, struct ("GI", 0)), [-1 -0.5]);
%! assert (elongation_numbers ([0 1 2 1], rod, struct ("GI", 1)), -1);
%! assert (elongation_numbers ([0 1 2], setfield (rod, "curvature", 3), struct ("GI", 0)), -1);
%! assert (elongation_numbers ([], rod, struct ("GI", 0)), zeros (1, 0));
%!test # what the docstring says of N sines
%! base = base_functions (1:20, [], 2);
%! arrays = rod_arrays (base, struct ("rhoA", 1, "rhoI", 0, "EA", 5, "EI", 1, "GI", 0), 0);
%! tip = functions_at (base, 2);
%! assert (1 - tip*(arrays.stiffness_matrix \ tip.')*5/2, 0.2/20, 0.02*0.2/20);
