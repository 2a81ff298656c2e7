## -*- texinfo -*-
## @deftypefn {} {[@var{longitudinal}, @var{transversal}] =} functions_at (@var{base}, @var{stations}, @
##   @var{derivative})
## Values of all base functions, p-by-n each, at the @var{stations} (p numbers, m), so that v1 = longitudinal*V and
## v2 = transversal*V, or their first or second derivatives (1/m, 1/m^2) with @var{derivative} = 1 or 2.  Of a curved
## rod's @var{base} they are the displacements along the frame's axes, or stretching and turning of the centreline, or the
## slopes of these.
## @end deftypefn

function [longitudinal, transversal] = functions_at (base, stations, derivative = 0)
  if (isfield (base, "axis"))
    f = curved_functions (base, base.axis, stations);
    by_derivative = {f.u_1, f.u_2; f.e, f.chi; f.e_slope, f.bend};
    [longitudinal, transversal] = by_derivative{derivative + 1,:};
    return;
  endif
  functions = {@rod_shape_longitudinal, @rod_shape_transversal; @rod_slope_longitudinal, @rod_slope_transversal
               @rod_curvature_longitudinal, @rod_curvature_transversal};
  [along, across] = functions{derivative + 1,:};
  [j1, xi1] = meshgrid (base.longitudinal, stations);
  [j2, xi2] = meshgrid (base.transversal, stations);
  longitudinal = [along(j1, xi1, base.length), zeros(size (j2))];
  transversal = [zeros(size (j1)), across(j2, xi2, base.length)];
endfunction

%!test # a quarter wave along, two half waves and a polynomial across
%! [along, across] = functions_at (base_functions (1, [2 -1], 2), [0; 1; 2]);
%! assert (along, [0 0 0; sin(pi/4) 0 0; 1 0 0], 1e-15);
%! assert (across, [0 0 0; 0 0 3/8; 0 0 0], 1e-15);
%! [along, across] = functions_at (base_functions (1, [2 -1], 2), 0, 1);
%! assert (along, [pi/4 0 0], 1e-15);
%! assert (across, [0 pi 1], 1e-15);
%! [along, across] = functions_at (base_functions (1, [2 -1], 2), 1, 2);
%! assert (along, [-(pi/4)^2*sin(pi/4) 0 0], 1e-14);
%! assert (across, [0 0 -3/4], 1e-14);
%!test # a curved rod's stretching and turning are the straight rod's derivatives, and so are their slopes
%! rod = struct ("length", 2, "curvature", 1, "curvature_breaks", []);
%! base = setfield (base_functions (1, [2 -1], 2), "axis", rod_axis (rod, 8));
%! [e_slope, bend] = functions_at (base, 1, 2);
%! assert ([e_slope; bend], [-(pi/4)^2*sin(pi/4) 0 0; 0 0 -3/4], 1e-14);
