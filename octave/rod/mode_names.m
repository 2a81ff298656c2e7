## -*- texinfo -*-
## @deftypefn {} {@var{names} =} mode_names (@var{base})
## The amplitudes' names, 1-by-N cellstr: V1_1, ..., V2_1, ... (V1_-1: the elongation by a force
## at the tip, V2_-1: the correction for a moment at O).
## @end deftypefn

function names = mode_names (base)
  names = [numbered("V1", base.longitudinal), numbered("V2", base.transversal)];
endfunction

function names = numbered (name, numbers)
  names = arrayfun (@(k) sprintf ("%s_%.12g", name, k), numbers, "uniformoutput", false);
endfunction

%!assert (mode_names (base_functions ([1 -0.5], [1 -1], 2)), {"V1_1", "V1_-0.5", "V2_1", "V2_-1"})
