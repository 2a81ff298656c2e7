## -*- texinfo -*-
## @deftypefn {} {@var{base} =} base_functions (@var{longitudinal}, @var{transversal}, @var{length})
## The base functions of a rod of that @var{length} (m) by their mode numbers, as vectors: (2), (3); of the
## longitudinal ones also -part, the elongation by a force at the station part*length (see @code{elongation_numbers}),
## and of the transversal ones -1 and -2, corrections for moments at O and at the tip.
## @end deftypefn

function base = base_functions (longitudinal, transversal, length)
  base = struct ("longitudinal", zeros (1, 0), "transversal", zeros (1, 0), "length", length);
  base.longitudinal(1:numel (longitudinal)) = longitudinal;
  base.transversal(1:numel (transversal)) = transversal;
endfunction

%!assert (base_functions (1:2, [1 -1], 3).transversal, [1 -1])
%!assert (base_functions ([], 1:2, 3), struct ("longitudinal", zeros (1, 0), "transversal", [1 2], "length", 3))
