## -*- texinfo -*-
## @deftypefn {} {@var{limit} =} measured_limit (@var{is_stable}, @var{predicted})
## The number beyond which @var{is_stable} (number) is false, by bisection to a thousandth between half of the
## @var{predicted} one and twice as much.
## @end deftypefn

function limit = measured_limit (is_stable, predicted)
  [low, high] = deal (predicted/2, 2*predicted);
  while (high - low > 1e-3*predicted)
    middle = (low + high)/2;
    if (is_stable (middle))
      low = middle;
    else
      high = middle;
    endif
  endwhile
  limit = (low + high)/2;
endfunction

%!assert (measured_limit (@(x) x < 1.3, 1), 1.3, 2e-3)
