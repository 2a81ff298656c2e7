## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{table}] =} energy_columns (@var{history})
## What history.csv has of the energies of any kind's @var{history}: kinetic and strain energy, potential energy of
## gravity, work of the loads and dissipated energy, with their units, a row each.
## @end deftypefn

function [names, table] = energy_columns (history)
  names = {"T [J]", "U [J]", "Z [J]", "W [J]", "D [J]"};
  table = [history.T; history.U; history.Z; history.W; history.D];
endfunction

%!test
%! [names, table] = energy_columns (struct ("W", 4, "T", 1, "U", 2, "Z", 3, "D", 5));
%! assert (names{4}, "W [J]"); assert (table, (1:5).');
