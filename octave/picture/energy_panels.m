## -*- texinfo -*-
## @deftypefn {} {@var{panels} =} energy_panels (@var{history})
## Two panels (see @code{new_panel}) of a @var{history} with the rows T, U, Z, W, D and balance (1-by-F, J): the
## energies that are not zero, as D without damping is, and how far their balance leaves its start.
## @end deftypefn

function panels = energy_panels (history)
  panels = without_zeros (new_panel ("energies", "J", {"T", "U", "Z", "D", "W"}, ...
                                     [history.T; history.U; history.Z; history.D; history.W]));
  name = regexprep (strjoin (panels.names, "+"), '\+?W', "−W");
  panels(2) = new_panel ("energy balance", "J", {name}, history.balance - history.balance(1));
endfunction

%!test
%! history = struct ("T", [0 1], "U", [0 2], "Z", [5 4], "W", [0 2], "D", [0 0.5], ...
%!                   "balance", [5 5.5]);
%! panels = energy_panels (history);
%! assert (panels(2).values, [0 0.5], 1e-15); assert (panels(2).names, {"T+U+Z+D−W"});
%!test # a rigid rod without loads
%! panels = energy_panels (struct ("T", [0 1], "U", [0 0], "Z", [5 4], "W", [0 0], "D", [0 0], "balance", [5 5]));
%! assert (panels(1).names, {"T", "Z"}); assert (panels(2).names, {"T+Z"});
