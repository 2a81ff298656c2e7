## -*- texinfo -*-
## @deftypefn {} {[@var{slope}, @var{strain}] =} largest_slopes (@var{model}, @var{V})
## The largest slope |v2,1| and the largest strain |v1,1| at 101 stations of a rod of @var{model} (length, base) with
## the amplitudes @var{V} of all base functions (N-by-m), 0 without any: how far it is from what its model holds for.
## @end deftypefn

function [slope, strain] = largest_slopes (model, V)
  [along, across] = functions_at (model.base, linspace (0, model.length, 101), 1);
  slope = max ([0; abs(across*V)(:)]);
  strain = max ([0; abs(along*V)(:)]);
endfunction

%!test # steepest where waves cross zero, most stretched at O, at any time; a rigid rod is neither
%! model = struct ("length", 2, "base", base_functions (1, 2, 2));
%! [slope, strain] = largest_slopes (model, [0 -0.1; 0.2 -0.3]);
%! assert ([slope, strain], [0.3*2*pi/2, 0.1*pi/4], 1e-14);
%! [slope, strain] = largest_slopes (setfield (model, "base", base_functions ([], [], 2)), zeros (0, 3));
%! assert ([slope, strain], [0 0]);
