## -*- texinfo -*-
## @deftypefn {} {@var{values} =} at_times (@var{f}, @var{t})
## The values of a function @var{f} of one time, an array of numbers, or of such numbers alone, at the times @var{t}
## (1-by-m, s), a column a time.
## @end deftypefn

function values = at_times (f, t)
  if (isnumeric (f))
    values = repmat (f(:), 1, numel (t));
    return;
  endif
  values = [arrayfun(@(t) f (t)(:), t, "uniformoutput", false){:}];
endfunction

%!assert (at_times (@(t) [t, 2*t], [1 2 3]), [1 2 3; 2 4 6])
%!assert (at_times ([1 2], [0 1 2]), [1 1 1; 2 2 2])
