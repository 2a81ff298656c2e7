## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} distance (@var{a}, @var{b})
## The largest distance (m) of two motions' points in all frames: @var{a} and @var{b} have the fields x and y, and z
## where they leave the plane, of one size.  It is Inf where one of them is not finite.
## @end deftypefn

function metres = distance (a, b)
  squares = (a.x - b.x).^2 + (a.y - b.y).^2;
  if (isfield (a, "z") && isfield (b, "z"))
    squares += (a.z - b.z).^2;
  endif
  metres = sqrt (max (squares(:)));
  if (! all (isfinite (squares(:))))
    metres = Inf;
  endif
endfunction

%!assert (distance (struct ("x", [0 1], "y", [0 1]), struct ("x", [0 4], "y", [0 5])), 5)
%!assert (distance (struct ("x", 0, "y", 0, "z", 0), struct ("x", 2, "y", 3, "z", 6)), 7)
%!assert (distance (struct ("x", [0 NaN], "y", [0 1]), struct ("x", [0 4], "y", [0 5])), Inf)
%!assert (distance (struct ("x", NaN, "y", NaN), struct ("x", [0 4], "y", [0 5], "z", [1 2])), Inf)
