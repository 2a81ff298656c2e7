## -*- texinfo -*-
## @deftypefn {} {@var{f} =} curved_functions (@var{base}, @var{axis}, @var{stations})
## The base functions of a curved rod at the @var{stations} (p numbers, m), p-by-n each: u_1, u_2 (displacements along
## and across the frame's x), e (stretching), e_slope, chi (turning of the tangent), bend (change of the curvature).
## The straight rod's base functions stand for what stretches and what turns, e = v1,1 and chi = v2,1; displacements
## are their integrals along the curve, so that bending does not stretch.  With base.polynomials, true, they are
## polynomials of Legendre for stretching and for bending (see @code{strain_polynomials}).
##
## base.turned (1-by-n), where it is there, is how far each is turned back so that it has no angular momentum.
## @end deftypefn

function f = curved_functions (base, axis, stations)
  [f.e, f.e_slope, f.chi, f.bend] = straight (base, stations(:));
  [at.e, ~, at.chi] = straight (base, axis.xi(:));
  theta = axis.theta(:).*ones (1, columns (at.e));
  [~, ~, slope_1, slope_2] = curved_rod_slopes (theta, at.e, at.chi);
  S = integrals_to (axis, stations);
  f.u_1 = S*slope_1;
  f.u_2 = S*slope_2;
  if (isfield (base, "turned"))
    [x, y] = undeformed_places (struct ("axis", axis), stations);
    f.u_1 += y(:)*base.turned;  # -turned P r
    f.u_2 -= x(:)*base.turned;
    f.chi -= base.turned;
  endif
endfunction

function [e, e_slope, chi, bend] = straight (base, xi)
  if (isfield (base, "polynomials"))
    [e, e_slope, chi, bend] = strain_polynomials (numel (base.longitudinal), numel (base.transversal), xi, base.length);
    return;
  endif
  straight_rod = struct ("longitudinal", base.longitudinal, "transversal", base.transversal, "length", base.length);
  [e, chi] = functions_at (straight_rod, xi, 1);
  [e_slope, bend] = functions_at (straight_rod, xi, 2);
endfunction

%!test # without curvature they are the straight rod's
%! base = base_functions (1:2, 1:3, 2);
%! axis = rod_axis (struct ("length", 2, "curvature", 0, "curvature_breaks", []), 8);
%! f = curved_functions (base, axis, [0.3 1.7]);
%! [along, across] = functions_at (base, [0.3 1.7]);
%! assert (f.u_1, along, 1e-12); assert (f.u_2, across, 1e-10);
