## -*- texinfo -*-
## @deftypefn {} {@var{stress} =} bending_stress (@var{rod}, @var{model}, @var{stations}, @var{V})
## The largest bending stress of the classical rod in the sections at the @var{stations} (p-by-m, Pa) with the amplitudes
## @var{V} (N-by-m), or [] where a rigid rod or an unknown section has none.
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
