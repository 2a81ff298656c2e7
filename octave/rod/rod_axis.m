## -*- texinfo -*-
## @deftypefn {} {@var{axis} =} rod_axis (@var{rod}, @var{panels}, @var{section}, @var{tip_mass})
## The undeformed centreline of a curved @var{rod} (a checked scene's field) at the Gauss points of so many equal
## @var{panels}, cut where its curvature jumps: a struct of xi (1-by-p, m), weights (m), ends (of the panels), kappa
## (1/m), theta (rad), x, y (m) and tilt (rad).  The frame's x axis goes from O through the centre of mass, that of the
## rod with its @var{tip_mass} (kg); tilt is the tangent's angle against it at O.  The @var{section} (see
## @code{rod_section}) counts where it is thick: it has more of its mass outside the centreline; by default it is thin.
## @end deftypefn

function axis = rod_axis (rod, panels, section = struct ("rhoA", 1, "rhoI", 0), tip_mass = 0)
  axis = panels_between (unique ([linspace(0, rod.length, panels + 1), rod.curvature_breaks(:).']));
  axis.kappa = curvature_at (rod, axis.xi);
  integral = integrals_to (axis, axis.xi);
  axis.theta = axis.kappa*integral.';
  [cosine, sine] = curved_rod_slopes (axis.theta, 0*axis.theta, 0*axis.theta);
  x = cosine*integral.';
  y = sine*integral.';
  axis.x = x;
  axis.y = y;
  [~, S_1, S_2] = curved_rod_constants (axis, section);
  to_tip = integrals_to (axis, rod.length).';
  axis.tilt = -atan2 (S_2*axis.weights.' + tip_mass*sine*to_tip, S_1*axis.weights.' + tip_mass*cosine*to_tip);
  axis.theta += axis.tilt;
  [axis.x, axis.y] = rod_centreline (axis.tilt*ones (size (x)), x, 0*x, y);
endfunction

%!test # a semicircle: length pi, its end at (0, 2) from O along the tangent, centre of mass at 2/pi of the radius
%! rod = struct ("length", pi, "curvature", 1, "curvature_breaks", []);
%! axis = rod_axis (rod, 8);
%! assert (sum (axis.weights), pi, 1e-12);
%! assert (axis.tilt, -atan2 (1, 2/pi), 1e-12);
%! assert (axis.weights*axis.y.', 0, 1e-12);
%! assert (axis.weights*axis.x.'/pi, hypot (2/pi, 1), 1e-12);
%!error <rod.curvature gives 1 values for 64 stations or no numbers: it takes a vectorised function of xi in 1/m>
%! rod_axis (struct ("length", 1, "curvature", @(xi) 2, "curvature_breaks", []), 8);
%!error <rod.curvature gives 64 values for 64 stations or no numbers>
%! rod_axis (struct ("length", 1, "curvature", @(xi) NaN*xi, "curvature_breaks", []), 8);
%!test # kappa = (2 + 3 xi/l)/l turns by 3.5 along the rod; a break ends a panel
%! axis = rod_axis (struct ("length", 2, "curvature", [1 1.5], "curvature_breaks", 0.3), 4);
%! assert (axis.weights*axis.kappa.', 3.5, 1e-12); assert (axis.ends, [0 0.3 0.5 1 1.5 2]);
