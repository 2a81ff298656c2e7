## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} distance (@var{a}, @var{b})
## The largest distance (m) of two centrelines' points in all frames: @var{a} and @var{b} have the fields x and y of
## one size.  It is Inf where one of them is not finite.
## @end deftypefn

function metres = distance (a, b)
  metres = max (hypot (a.x - b.x, a.y - b.y)(:));
  if (! all (isfinite ([a.x(:) + a.y(:); b.x(:) + b.y(:)])))
    metres = Inf;
  endif
endfunction

%!assert (distance (struct ("x", [0 1], "y", [0 1]), struct ("x", [0 4], "y", [0 5])), 5)
%!assert (distance (struct ("x", [0 NaN], "y", [0 1]), struct ("x", [0 4], "y", [0 5])), Inf)
