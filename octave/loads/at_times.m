## -*- texinfo -*-
## @deftypefn {} {@var{values} =} at_times (@var{f}, @var{t})
## The values of a function @var{f} of one time, numbers in a row or a column, at the times @var{t} (1-by-m, s), a
## column a time.
## @end deftypefn

function values = at_times (f, t)
  values = f (t(1))(:);
  for k = 2:numel (t)
    values(:,k) = f (t(k));
  endfor
endfunction

%!assert (at_times (@(t) [t, 2*t], [1 2 3]), [1 2 3; 2 4 6])
