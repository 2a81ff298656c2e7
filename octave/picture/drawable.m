## -*- texinfo -*-
## @deftypefn {} {@var{values} =} drawable (@var{values})
## The @var{values} as gnuplot can draw them, with margins and steps of tics between them: those beyond 1e300 end
## there, and those below 1e-300, of which nothing could be said, are 0.
## @end deftypefn

function values = drawable (values)
  values = min (max (values, -1e300), 1e300);
  values(abs (values) < 1e-300) = 0;
endfunction

%!assert (drawable ([-realmax, -2, -5e-324, 0, 1e-299, realmax]), [-1e300, -2, 0, 0, 1e-299, 1e300])
