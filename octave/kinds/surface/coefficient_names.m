## -*- texinfo -*-
## @deftypefn {} {@var{names} =} coefficient_names (@var{numbers})
## Names of the coefficients q of a rod on a surface (1-by-N cellstr), of the @var{numbers} of polynomials, modes, and
## sines of each of the chart's coordinates (a struct of 1-by-2).
## @end deftypefn

function names = coefficient_names (numbers)
  names = [numbered("alpha1", numbers, 1), numbered("alpha2", numbers, 2)];
endfunction

function names = numbered (name, numbers, i)
  names = [arrayfun(@(k) sprintf ("%s_%d", name, k), 0:numbers.modes(i)-1, "uniformoutput", false), ...
           arrayfun(@(k) sprintf ("%s_sine_%d", name, k), 1:numbers.sines(i), "uniformoutput", false)];
endfunction

%!assert (coefficient_names (struct ("modes", [2 1], "sines", [0 1])),
%!  {"alpha1_0", "alpha1_1", "alpha2_0", "alpha2_sine_1"});
