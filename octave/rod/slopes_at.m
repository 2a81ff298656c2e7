## -*- texinfo -*-
## @deftypefn {} {[@var{slope_1}, @var{slope_2}] =} slopes_at (@var{base}, @var{station}, @var{shortening})
## What of the tangent's angle at the @var{station} (m) comes from each base function, along and across (N-by-1, 1/m,
## equation (27)).  With @var{shortening} (1 or 0) v1 is the stretch along the bent rod, which does not turn its
## tangent.
## @end deftypefn

function [slope_1, slope_2] = slopes_at (base, station, shortening)
  [along, across] = functions_at (base, station, 1);
  slope_1 = along.'*(1 - shortening);
  slope_2 = across.';
endfunction

%!test # sines of 2 m: k pi/l, and at the tip with changing signs
%! base = base_functions (1:2, 1:2, 2);
%! [slope_1, slope_2] = slopes_at (base, 0, 0);
%! assert (slope_2, [0; 0; 1; 2]*pi/2, 1e-12); assert (slope_1(1:2) != 0); assert (slope_1(3:4), [0; 0]);
%! assert (slopes_at (base, 0, 1), zeros (4, 1));
%! [slope_1, slope_2] = slopes_at (base, 2, 0);
%! assert (slope_2, [0; 0; -1; 2]*pi/2, 1e-12); assert (slope_1, zeros (4, 1), 1e-12);
