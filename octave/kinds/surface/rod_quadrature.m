## -*- texinfo -*-
## @deftypefn {} {[@var{xi}, @var{weights}, @var{n}] =} rod_quadrature (@var{scene})
## Stations (p-by-1, m) and weights (m) of a quadrature along the rod of a checked @var{scene} on a surface, with numbers
## of modes: @var{n} Gauss points for its base functions, between the ends, or, of an exact rod (see @code{exact_kind}),
## so many from jump to jump of its curvature.
## @end deftypefn

function [xi, weights, n] = rod_quadrature (scene)
  ends = [0, scene.rod.length];
  n = 2*max (scene.model.modes) + 4*max (scene.model.sines) + 6;
  if (isfield (scene, "exact") && ! isempty (scene.rod.curvature))
    ends = unique ([ends, scene.rod.curvature_breaks(:).']);
    n += 8;  # arcs are no polynomials
  endif
  [x, w] = gauss_rule (n);
  xi = (ends(1:end-1) + diff (ends).*x.')(:);
  weights = (diff (ends).*w.')(:);
endfunction

%!test # polynomials on a rod, and those of two parts
%! scene = struct ("rod", struct ("length", 2, "curvature", []), "model", struct ("modes", [3 4], "sines", [0 0]));
%! [xi, weights] = rod_quadrature (scene);
%! assert (numel (xi), 14); assert (weights.'*xi.^3, 4, 1e-13);
%! scene.exact = 0; scene.rod.curvature = 1; scene.rod.curvature_breaks = 0.5;
%! [xi, weights] = rod_quadrature (scene);
%! assert (weights.'*(xi > 0.5), 1.5, 1e-13); assert (weights.'*((xi > 0.5).*xi.^2), (8 - 0.125)/3, 1e-13);
%! assert (numel (xi), 44);
