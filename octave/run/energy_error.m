## -*- texinfo -*-
## @deftypefn {} {@var{error} =} energy_error (@var{history})
## How far the balance T + U + Z + D - W of a @var{history} (see @code{measure}) is off from its start at each of its
## times (1-by-m), as a part of what changes: the largest of the differences between the largest and the smallest T,
## U, Z, W and D.
##
## What hardly changes has a floor: a millionth of the largest energy, which is as far as rounding may be taken for a
## change, and history.energy_floor (J, see @code{energy_floor}), so that a rod at rest has an error of 0.
## @end deftypefn

function error = energy_error (history)
  [~, E] = energy_columns (history);
  change = max (max (E, [], 2) - min (E, [], 2));
  smallest = max ([1e-6*max(abs (E(:))), history.energy_floor]);
  error = abs (history.balance - history.balance(1))/max (change, smallest);
endfunction

%!function history = of_energies (T, Z, balance)
%!  history = struct ("T", T, "U", 0*T, "Z", Z, "W", 0*T, "D", 0*T, "balance", balance, "energy_floor", 1e-12);
%!endfunction
%!assert (energy_error (of_energies ([0 2], [5 4], [5 6])), [0 0.5])
%!test # 230 J of a rotation that stays do not hide a tenth of the 0.018 J that change
%! assert (energy_error (of_energies ([230 230.018], [0 0], [230 230.0018]))(2), 0.1, 1e-6);
%!test # at rest: nothing, and rounding is nothing
%! assert (energy_error (of_energies ([0 0], [5 5], [5 5])), [0 0]);
%! assert (energy_error (of_energies ([0 0], [0 0], [0 0])), [0 0]);
%! assert (energy_error (of_energies ([0 1e-32], [0 0], [0 1e-32])) < 1e-19);
%! assert (energy_error (of_energies ([0 0], [5 5], [5, 5*(1 + eps)])) < 1e-9);
