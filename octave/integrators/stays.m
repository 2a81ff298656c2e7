## -*- texinfo -*-
## @deftypefn {} {@var{still} =} stays (@var{q}, @var{scale}, @var{tolerance})
## True where coordinates @var{q} (n-by-m, a column a time) stay where they began: no point of the rods is further from
## there than the @var{tolerance} (m) at any time.  @var{scale} (n-by-1): what each may be off by where a point is off
## by 1 m.
## @end deftypefn

function still = stays (q, scale, tolerance)
  still = all ((abs (q - q(:,1)) <= tolerance*scale)(:));
endfunction

%!assert (stays ([1 1.01; 2 2], [1; 1], 0.1))
%!assert (! stays ([1 1.01; 2 2], [0.01; 1], 0.1))
%!assert (! stays ([1 NaN], 1, 0.1))
