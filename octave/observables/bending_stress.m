## -*- texinfo -*-
## @deftypefn {} {@var{stress} =} bending_stress (@var{rod}, @var{model}, @var{stations}, @var{V})
## The largest bending stress of the classical rod in the sections at the @var{stations} (p-by-m, Pa) with the
## amplitudes @var{V} (N-by-m), or [] where a rigid rod or an unknown section has none.
## @end deftypefn

function stress = bending_stress (rod, model, stations, V)
  stress = [];
  if (! isempty (rod.half_height) && ! isempty (model.base.transversal) && ! isempty (rod.width))
    [j, xi1] = meshgrid (model.base.transversal, stations);
    V2 = V(numel (model.base.longitudinal)+1:end,:);
    stress = rod_bending_stress (rod_curvature_transversal (j, xi1, model.length)*V2, rod.half_height, ...
                                 rod.lambda, rod.mu);
  endif
endfunction

%!test # a half wave: E h times the curvature; none without a section
%! model = struct ("base", base_functions ([], 1, 2), "length", 2);
%! rod = struct ("half_height", 0.01, "width", 0.02, "lambda", 0, "mu", 1e11);
%! assert (bending_stress (rod, model, 1, 0.1), 2e11*0.01*(pi/2)^2*0.1, 1);
%! assert (isempty (bending_stress (setfield (rod, "width", []), model, 1, 0.1)));
