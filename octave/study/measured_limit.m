## -*- texinfo -*-
## @deftypefn {} {@var{limit} =} measured_limit (@var{is_stable}, @var{predicted})
## The number beyond which @var{is_stable} (number) is false, by bisection to a thousandth between half of the
## @var{predicted} one and twice as much.  As that is mostly near, what is stable and what is not is first looked for
## beside it: the bisection asks between these alone.
## @end deftypefn

function limit = measured_limit (is_stable, predicted)
  [stable, unstable] = beside (is_stable, predicted);
  [low, high] = deal (predicted/2, 2*predicted);
  while (high - low > 1e-3*predicted)
    middle = (low + high)/2;
    if (middle <= stable || middle < unstable && is_stable (middle))
      low = middle;
    else
      high = middle;
    endif
  endwhile
  limit = (low + high)/2;
endfunction

## two numbers, the one stable, the other not, as near to the predicted one as distances of 0.2 %, four times that,
## and so on, let them be found; of the ends of the bisection that is not asked
function [stable, unstable] = beside (is_stable, predicted)
  away = 0.002*4.^(0:3);
  below = predicted*[1 - away, 1/2];
  above = predicted*[1 + away, 2];
  j = k = 1;
  while (j < numel (below) && ! is_stable (below(j)))
    j++;
  endwhile
  stable = below(j);
  if (j > 1)
    unstable = below(j-1);
    return;
  endif
  while (k < numel (above) && is_stable (above(k)))
    k++;
  endwhile
  unstable = above(k);
  if (k > 1)
    stable = above(k-1);
  endif
endfunction

%!function stable = near_one (x, exact)
%!  assert (x, 1, 0.01);
%!  stable = x < exact;
%!endfunction
%!test # the middle of what a bisection of the whole ends with, near or far, to either side
%! width = 1.5/2^11;
%! for exact = [0.51 0.9 0.995 0.9985 0.9995 1.0015 1.01 1.3 1.99]
%!   middle = 0.5 + (floor ((exact - 0.5)/width) + 0.5)*width;
%!   assert (measured_limit (@(x) x < exact, 1), middle, 1e-12);
%! endfor
%!test # nothing far from the predicted one is asked for
%! assert (measured_limit (@(x) near_one (x, 1.003), 1), 1.003, 1e-3);
