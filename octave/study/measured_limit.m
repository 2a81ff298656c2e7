## -*- texinfo -*-
## @deftypefn {} {@var{limit} =} measured_limit (@var{method}, @var{predicted})
## The h*omega beyond which a @var{method} lets the highest mode of the rod grow (see @code{mode_growth}), by bisection
## to a thousandth between half of the @var{predicted} one and twice as much.
## @end deftypefn

function limit = measured_limit (method, predicted)
  solver = struct ("name", method, "tolerance", 1, "rho_infinity", 1);
  [low, high] = deal (predicted/2, 2*predicted);
  while (high - low > 1e-3*predicted)
    middle = (low + high)/2;
    if (mode_growth (solver, middle) <= 1 + 1e-7)
      low = middle;
    else
      high = middle;
    endif
  endwhile
  limit = (low + high)/2;
endfunction

%!assert (measured_limit ("stormer_verlet", 2), 2, 0.02)
