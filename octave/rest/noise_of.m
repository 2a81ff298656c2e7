## -*- texinfo -*-
## @deftypefn {} {@var{omega} =} noise_of (@var{y}, @var{M}, @var{K})
## How fast (rad/s, 1-by-m) motions @var{y} (p-by-m) of the mass @var{M} may seem to vibrate by the rounding of a
## stiffness @var{K} (p-by-p), which may cancel in them.
## @end deftypefn

function omega = noise_of (y, M, K)
  omega = sqrt (10*eps*sum (abs (y).*(abs (K)*abs (y)), 1)./real (sum (conj (y).*(M*y), 1)));
endfunction

%!test # a stiff spring between two masses that move as one, and against each other
%! omega = noise_of ([1 1; 1 -1], eye (2), 1e12*[1 -1; -1 1]);
%! assert (omega, sqrt (20*eps*1e12)*[1 1], 1e-12);
