## -*- texinfo -*-
## @deftypefn {} {@var{names} =} mode_names (@var{base})
## The amplitudes' names, 1-by-N cellstr: V1_1, ..., V2_1, ... (V2_-1: the correction for a moment at O).
## @end deftypefn

function names = mode_names (base)
  names = [numbered("V1", base.longitudinal), numbered("V2", base.transversal)];
endfunction

function names = numbered (name, numbers)
  names = arrayfun (@(k) sprintf ("%s_%d", name, k), numbers, "uniformoutput", false);
endfunction

%!assert (mode_names (base_functions (1, [1 -1], 2)), {"V1_1", "V2_1", "V2_-1"})
