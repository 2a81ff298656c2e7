## -*- texinfo -*-
## @deftypefn {} {@var{stress} =} bending_stress (@var{rod}, @var{model}, @var{stations}, @var{V})
## The largest bending stress in the sections at the @var{stations} (p-by-m, Pa) with the amplitudes @var{V} (N-by-m),
## M h/I of the bending moment that the @var{model} has there; or [] where a rigid rod has none, or where it does not
## follow from what the @var{rod} states (see @code{stress_unknown}).
## @end deftypefn

function stress = bending_stress (rod, model, stations, V)
  stress = [];
  if (isempty (stress_unknown (rod)) && ! isempty (model.base.transversal))
    [~, bends] = functions_at (model.base, stations, 2);
    stress = rod_bending_stress (bends*V, rod.width, rod.half_height, model.section.EI);
  endif
endfunction

%!shared model, rod
%! model = struct ("base", base_functions ([], 1, 2), "length", 2, "section", struct ("EI", 3));
%! rod = struct ("half_height", 0.01, "width", 0.02, "EA", [], "EI", []);
%!test # a half wave: M h/I, and it is E h times the curvature for the material that makes EI of the section
%! I = 0.02*0.02^3/12;
%! assert (bending_stress (rod, model, 1, 0.1), 3*(pi/2)^2*0.1*0.01/I, 1e-6);
%! model.section.EI = 2e11*I;
%! assert (bending_stress (rod, model, 1, 0.1), 2e11*0.01*(pi/2)^2*0.1, 1);
%!test # stiffnesses that are stated: those of rubber bend it with the stress of rubber
%! I = 0.02*0.02^3/12;
%! rod.EI = model.section.EI = 1e6*I; rod.EA = 1e6*0.02*0.02;
%! assert (bending_stress (rod, model, 1, 0.1), 1e6*0.01*(pi/2)^2*0.1, 1e-6);
%!test # none where the rod does not say how wide it is, or is no rectangle
%! assert (isempty (bending_stress (setfield (rod, "width", []), model, 1, 0.1)));
%! [rod.EA, rod.EI] = deal (1e6, 1);
%! assert (isempty (bending_stress (rod, model, 1, 0.1)));
