## -*- texinfo -*-
## @deftypefn {} {@var{names} =} coefficient_names (@var{numbers})
## Names of the coefficients q of a rod on a surface (1-by-N cellstr), of the @var{numbers} of polynomials, modes, and
## sines of each of the chart's coordinates, and the rod's own (see @code{own_functions}).
## @end deftypefn

function names = coefficient_names (numbers)
  names = [numbered("alpha1", numbers, 1), numbered("alpha2", numbers, 2)];
endfunction

function names = numbered (name, numbers, i)
  of = @(template, numbers) arrayfun (@(k) sprintf (template, name, k), numbers, "uniformoutput", false);
  names = [of("%s_%d", 0:numbers.modes(i)-1), of("%s_sine_%d", 1:numbers.sines(i)), ...
           of("%s_own_%d", 1:numbers.own.count(i))];
endfunction

%!assert (coefficient_names (struct ("modes", [2 1], "sines", [0 1], "own", struct ("count", [1 0]))),
%!  {"alpha1_0", "alpha1_1", "alpha1_own_1", "alpha2_0", "alpha2_sine_1"});
