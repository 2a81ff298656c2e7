## -*- texinfo -*-
## @deftypefn {} {@var{of} =} largest_slopes (@var{model}, @var{basis})
## A function [slope, strain] = of (@var{V}) that has the largest slope |v2,1| and the largest strain |v1,1| at 101
## stations of a rod of @var{model} (length, base) with the amplitudes @var{V} of all base functions (N-by-m), or those
## of the modes of a @var{basis} (N-by-n), 0 without any: how far it is from what its model holds for.
## @end deftypefn

function of = largest_slopes (model, basis = 1)
  [along, across] = functions_at (model.base, linspace (0, model.length, 101), 1);
  [along, across] = deal (along*basis, across*basis);
  of = @(V) largest (across*V, along*V);
endfunction

function [slope, strain] = largest (slopes, strains)
  slope = max ([0; abs(slopes(:))]);
  strain = max ([0; abs(strains(:))]);
endfunction

%!test # steepest where waves cross zero, most stretched at O, at any time; a rigid rod is neither
%! model = struct ("length", 2, "base", base_functions (1, 2, 2));
%! of = largest_slopes (model);
%! [slope, strain] = of ([0 -0.1; 0.2 -0.3]);
%! assert ([slope, strain], [0.3*2*pi/2, 0.1*pi/4], 1e-14);
%! assert (largest_slopes (model, [0; 0.1])([2 3]), 0.3*2*pi/2, 1e-14);
%! of = largest_slopes (setfield (model, "base", base_functions ([], [], 2)));
%! [slope, strain] = of (zeros (0, 3));
%! assert ([slope, strain], [0 0]);
