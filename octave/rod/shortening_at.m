## -*- texinfo -*-
## @deftypefn {} {@var{Q} =} shortening_at (@var{base}, @var{station})
## What the station (m) comes nearer to O where the rod bends is V.Q.V/2: @var{Q} is n-by-n (1/m).
## @end deftypefn

function Q = shortening_at (base, station)
  [k, j] = meshgrid (base.transversal, base.transversal);
  Q = blkdiag (zeros (numel (base.longitudinal)), rod_shortening (j, k, station, base.length));
endfunction

%!test # the integral of the slopes' product
%! base = base_functions (1, [1 3 -1 -2], 2);
%! Q = shortening_at (base, 1.3);
%! slope = @(k, x) rod_slope_transversal (base.transversal(k), x, 2);
%! for pair = [1 1; 1 2; 2 2; 1 3; 2 4; 3 4; 4 4].'
%!   expected = quadgk (@(x) slope (pair(1), x).*slope (pair(2), x), 0, 1.3);
%!   assert (Q(pair(1) + 1, pair(2) + 1), expected, 1e-9);
%!   assert (Q(pair(2) + 1, pair(1) + 1), expected, 1e-9);
%! endfor
