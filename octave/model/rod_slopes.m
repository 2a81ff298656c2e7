## -*- texinfo -*-
## @deftypefn {} {[@var{slope_1}, @var{slope_2}] =} rod_slopes (@var{modes}, @var{xi1}, @var{length})
## Slopes of all base functions at the station @var{xi1} (m): n-by-1 vectors (1/m) that give v1,1 and v2,1 there as
## scalar products with V.
## @end deftypefn

function [slope_1, slope_2] = rod_slopes (modes, xi1, length)
  slope_1 = [rod_slope_longitudinal((1:modes(1)).', xi1, length); zeros(modes(2), 1)];
  slope_2 = [zeros(modes(1), 1); rod_slope_transversal((1:modes(2)).', xi1, length)];
endfunction

%!test
%! [slope_1, slope_2] = rod_slopes ([1 2], 0, 2);
%! assert (slope_1, [pi/4; 0; 0], 1e-15);
%! assert (slope_2, [0; pi/2; pi], 1e-15);
