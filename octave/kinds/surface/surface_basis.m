## -*- texinfo -*-
## @deftypefn {} {@var{base} =} surface_basis (@var{scene}, @var{place}, @var{stations}, @var{weights})
## The functions along a rod on a surface at @var{stations} (p-by-1, m) of it, for both coordinates of the chart: cell
## arrays of two, values, slopes (1/m) and seconds (1/m^2; p-by-n, of the coordinates z that the ends leave free, see
## @code{place_rod}), the same of the start, start_values, start_slopes, start_seconds (p-by-1), and kappa (p-by-1,
## 1/m), the curvature of the undeformed rod. With @var{weights} (p-by-1; those of a quadrature) it has these, and
## onto: what sums densities there, one below the other, of two, four and all six of these functions (n-by-2p, n-by-4p,
## n-by-6p).
## @end deftypefn

function base = surface_basis (scene, place, stations, weights = [])
  base.kappa = curvature_at (scene.rod, stations);
  last = 0;
  for i = 1:2
    [base.values{i}, base.slopes{i}, base.seconds{i}] = rod_functions (scene.model, i, stations, scene.rod.length);
    part = last + (1:columns (base.values{i}));
    last = part(end);
    for kind = {"values", "slopes", "seconds"}
      base.(["start_" kind{1}]){i} = base.(kind{1}){i}*place.start(part);
      base.(kind{1}){i} *= place.basis(part,:);
    endfor
  endfor
  if (! isempty (weights))
    base.weights = weights;
    all_of = [base.values, base.slopes, base.seconds];
    base.onto = arrayfun (@(k) vertcat (all_of{1:2*k}).'.*repmat (weights, 2*k, 1).', 1:3, "uniformoutput", false);
  endif
endfunction

%!test # a straight rod along the first coordinate of the plane: alpha1 = xi at the start
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, ...
%!                 "rod", struct ("length", 2, "EA", 3, "EI", 1, "rhoA", 1), "model", struct ("modes", [3 3]));
%! scene = check_surface_scene (scene);
%! base = surface_basis (scene, surface_rod (scene).place, [0; 0.5; 2]);
%! assert (base.start_values{1}, [0; 0.5; 2], 1e-12); assert (base.start_slopes{1}, [1; 1; 1], 1e-12);
%! assert (size (base.values{2}), [3 6]);
