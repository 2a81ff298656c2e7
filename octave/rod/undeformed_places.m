## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}, @var{theta}] =} undeformed_places (@var{base}, @var{stations})
## Places (1-by-p, m) and tangent's angles (rad) of the undeformed centreline at the @var{stations} (m), in the rod's
## frame: on its x axis, or where a curved rod's base.axis (see @code{rod_axis}) has them.
## @end deftypefn

function [x, y, theta] = undeformed_places (base, stations)
  if (! isfield (base, "axis"))
    x = stations(:).';
    y = theta = 0*x;
    return;
  endif
  axis = base.axis;
  S = integrals_to (axis, stations);
  theta = axis.tilt + (S*axis.kappa.').';
  [cosine, sine] = curved_rod_slopes (axis.theta, 0*axis.theta, 0*axis.theta);
  x = (S*cosine.').';
  y = (S*sine.').';
endfunction

%!test # the end of a semicircle
%! axis = rod_axis (struct ("length", pi, "curvature", 1, "curvature_breaks", []), 8);
%! [x, y, theta] = undeformed_places (struct ("axis", axis), pi);
%! assert (hypot (x, y), 2, 1e-12); assert (theta - axis.tilt, pi, 1e-12);
%!test # a straight rod lies on the x axis
%! [x, y, theta] = undeformed_places (struct (), [0; 0.5; 2]);
%! assert ([x; y; theta], [0 0.5 2; 0 0 0; 0 0 0]);
