## -*- texinfo -*-
## @deftypefn {} {@var{matrix} =} slopes_of_points (@var{system}, @var{stations})
## The matrix (m-by-p) that makes of values at the p points of the quadrature of @code{surface_rod} the slopes (1/m) at
## the @var{stations} (m-by-1, m) of the polynomial through them.
## @end deftypefn

function matrix = slopes_of_points (system, stations)
  degree = numel (system.points) - 4;  # a little below interpolation, against rounding
  length = sum (system.weights);
  values = legendre_functions (degree, system.points, length);
  [~, slopes] = legendre_functions (degree, stations, length);
  weighted = values.'.*system.weights.';
  matrix = slopes*((weighted*values) \ weighted);
endfunction

%!test # of a cubic polynomial
%! system = surface_rod (check_surface_scene (setfield (on_level_plane (), "model", "modes", [5 5])));
%! x = [0; 0.7; 2];
%! assert (slopes_of_points (system, x)*(system.points.^3 - 2*system.points), 3*x.^2 - 2, 1e-10);
