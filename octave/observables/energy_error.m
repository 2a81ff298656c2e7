## -*- texinfo -*-
## @deftypefn {} {@var{error} =} energy_error (@var{history})
## How far the balance T + U + Z + D - W of a @var{history} (see @code{measure}) is off from its start at each of its
## times (1-by-m), as a part of the largest energy.
## @end deftypefn

function error = energy_error (history)
  largest = max (abs ([history.T, history.U, history.Z - history.Z(1), history.W]));
  error = abs (history.balance - history.balance(1))/max (largest, realmin);
endfunction

%!assert (energy_error (struct ("T", [0 2], "U", [0 0], "Z", [5 4], "W", [0 0], "balance", [5 6])), [0 0.5])
