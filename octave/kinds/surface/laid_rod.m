## -*- texinfo -*-
## @deftypefn {} {@var{alpha} =} laid_rod (@var{surface}, @var{rod}, @var{point}, @var{angle}, @var{stations})
## The chart's coordinates (2-by-m) of a @var{rod} (a checked scene's field) that lies undeformed on the @var{surface}
## (see @code{surface_functions}), a straight one on a geodesic, at its @var{stations} (1-by-m, m, ascending from 0):
## from the @var{point} (2 coordinates) at the @var{angle} (rad) from the chart's first direction to its second.
## @end deftypefn

function alpha = laid_rod (surface, rod, point, angle, stations)
  place = struct ("alpha1", point(1), "alpha2", point(2));
  [a_11, a_12, a_22] = surface.mass (place, struct ("rhoA", 1));
  [slope_1, slope_2] = surface.direction (place, angle);
  slope = [slope_1; slope_2];
  if (! (all (isfinite (slope)) && isreal (slope) && a_11*a_22 - a_12^2 > 1e-12*(a_11 + a_22)^2))
    scene_error ("initial.point is [%g %g]: the surface's chart is singular there", point);
  endif
  settings = {lsode_options("relative tolerance"), lsode_options("absolute tolerance"), lsode_options("step limit"), ...
              lsode_options("maximum step size")};
  unwind_protect
    lsode_options ("relative tolerance", 1e-13);
    lsode_options ("absolute tolerance", 1e-13);
    lsode_options ("step limit", 1e5);
    lsode_options ("maximum step size", stations(end)/50);  # not over a bend between straight parts
    [path, state] = told_errors (@(f) lsode (f, [point(:); slope], [0; stations(:)]), ...
                                 @(y, s) rate (y, s, surface, rod, 1e8*norm (slope)));
  unwind_protect_cleanup
    lsode_options ("relative tolerance", settings{1});
    lsode_options ("absolute tolerance", settings{2});
    lsode_options ("step limit", settings{3});
    lsode_options ("maximum step size", settings{4});
  end_unwind_protect
  if (state != 2 || ! all (isfinite (path(:))))
    refuse_singular_way ();
  endif
  alpha = path(2:end,1:2).';
endfunction

## lsode itself would say at length that its steps shrink to nothing
function y_dot = rate (y, xi, surface, rod, steepest)
  if (norm (y(3:4)) > steepest)
    refuse_singular_way ();
  endif
  place = struct ("alpha1", y(1), "alpha2", y(2), "alpha1_1", y(3), "alpha2_1", y(4), "kappa", curvature_at (rod, xi));
  [second_1, second_2] = surface.laid (place);
  y_dot = [y(3); y(4); second_1; second_2];
endfunction

function refuse_singular_way ()
  scene_error ("initial.point and initial.angle lay the rod across a point where the surface's chart is singular");
endfunction

%!test # a great circle through the lowest point, as long as it is
%! surface = surface_functions (struct ("name", "sphere", "radius", 2));
%! alpha = laid_rod (surface, struct ("curvature", 0), [0 0], 0.3, [0 0.5 1.5]);
%! [x, y, z] = surface.position (struct ("alpha1", alpha(1,:), "alpha2", alpha(2,:)));
%! s = [0 0.5 1.5];
%! assert ([x; y; z], 2*[cos(0.3)*sin(s/2); sin(0.3)*sin(s/2); -cos(s/2)], 1e-10);
%!error <initial.point is \[0 1\]: the surface's chart is singular there>
%! laid_rod (surface_functions (struct ("name", "cone", "half_angle", 1)), [], [0 1], 0, [0 1]);
%!test # on a saddle, whose chart is oblique: as long as it is, and at its angle to the first direction
%! surface = surface_functions (struct ("name", "saddle", "rise", 1.5, "fall", 0.7));
%! s = linspace (0, 1, 401);
%! alpha = laid_rod (surface, struct ("curvature", 0), [0.3 0.2], 0.7, s);
%! [x, y, z] = surface.position (struct ("alpha1", [alpha(1,:), 0.3 + 1e-6], "alpha2", [alpha(2,:), 0.2]));
%! p = [x; y; z];
%! assert (alpha(:,1), [0.3; 0.2], 1e-12);
%! assert (norm (diff (p(:,1:401), 1, 2), "columns"), s(2)*ones (1, 400), 1e-5*s(2));
%! first = (p(:,402) - p(:,1))/norm (p(:,402) - p(:,1));
%! assert (first.'*(p(:,2) - p(:,1))/s(2), cos (0.7), 3e-3);
%! assert (alpha(2,2) > alpha(2,1));
%!test # straight, a short bend, straight
%! bend = struct ("curvature", @(xi) 5*(xi > 0.5 & xi < 0.6), "length", 1);
%! surface = surface_functions (struct ("name", "plane", "inclination", pi/2));
%! alpha = laid_rod (surface, bend, [0 0], 0, [0 1]);
%! assert (alpha(:,2), [0.5 + sin(0.5)/5 + 0.4*cos(0.5); (1 - cos (0.5))/5 + 0.4*sin(0.5)], 1e-5);
%!test # a small circle of a sphere, of which the geodesic curvature is the tangent of its height over its radius
%! surface = surface_functions (struct ("name", "sphere", "radius", 2));
%! height = -2*sin (0.3);
%! r = 2*cos (0.3);
%! from = 2*r/(1 - height/2);  # in the chart
%! s = linspace (0, 2*pi*r, 9);
%! alpha = laid_rod (surface, struct ("curvature", tan (0.3)/2, "length", s(end)), [from 0], pi/2, s);
%! assert (alpha, from*[cos(s/r); sin(s/r)], 1e-9);
%!error <initial.point is \[0 0\]: the surface's chart is singular there> # its lines are nearly parallel
%! surface.mass = @(place, rod) deal (1, 1 - 1e-12, 1);
%! surface.direction = @(place, angle) deal (1, 0);
%! laid_rod (surface, [], [0 0], 0, [0 1]);
%!error <lay the rod across a point where the surface's chart is singular> # a sphere's, opposite to its start
%! laid_rod (surface_functions (struct ("name", "sphere", "radius", 0.2)), struct ("curvature", 0), [0 0], 0, [0 1]);
%!error <lay the rod across a point where the surface's chart is singular> # its way ends before it does
%! surface.mass = @(place, rod) deal (1, 0, 1);
%! surface.direction = @(place, angle) deal (1, 0);
%! surface.laid = @(place) deal (place.alpha1_1^1.5, 0);
%! laid_rod (surface, struct ("curvature", 0), [0 0], 0, [0 3]);
