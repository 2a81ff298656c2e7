## -*- texinfo -*-
## @deftypefn {} {@var{panels} =} energy_panels (@var{history})
## Two panels (see @code{new_panel}) of a @var{history} with the rows T, U, Z, W, D (1-by-F, J): the energies, and how
## far their balance leaves its start.
## @end deftypefn

function panels = energy_panels (history)
  panels = new_panel ("energies", "J", {"T", "U", "Z", "W", "D"}, ...
                      [history.T; history.U; history.Z; history.W; history.D]);
  balance = history.T + history.U + history.Z + history.D - history.W;
  panels(2) = new_panel ("energy balance", "J", {"T+U+Z+D−W"}, balance - balance(1));
endfunction

%!test
%! history = struct ("T", [0 1], "U", [0 2], "Z", [5 4], "W", [0 2], "D", [0 0.5]);
%! assert (energy_panels (history)(2).values, [0 0.5], 1e-15);
