## -*- texinfo -*-
## @deftypefn {} {} refuse_singular (@var{surface}, @var{fields}, @var{when})
## An error where the rod lies on or across a point at which the surface's chart is singular, or has left the chart:
## the determinant of the first fundamental form vanishes beside its largest on the rod, it or the normal is no
## number, or the normal turns round between two points.  @var{fields} as from @code{surface_rod}, p points of the rod
## by m times, @var{when} a text.
## @end deftypefn

function refuse_singular (surface, fields, when)
  [n_1, n_2, n_3, determinant] = surface.normal (fields);
  remedy = "; try another chart of the surface, or a rod that keeps away";
  if (! (isreal (determinant) && all (isfinite ([determinant, n_1, n_2, n_3](:)))))
    error ("toolchain:integration", "the rod leaves the chart %s: the surface has no metric there%s\n", when, remedy);
  endif
  flips = n_1(1:end-1,:).*n_1(2:end,:) + n_2(1:end-1,:).*n_2(2:end,:) + n_3(1:end-1,:).*n_3(2:end,:) < 0;
  if (any (flips(:)) || any (vec (determinant <= 1e-4*max (determinant, [], 1))))
    [~, k] = min (min (determinant, [], 2));
    text = "the rod meets a point %s where the surface's chart is singular, near alpha = (%.3g, %.3g)%s\n";
    error ("toolchain:integration", text, when, fields.alpha1(k,1), fields.alpha2(k,1), remedy);
  endif
endfunction

%!error <the rod meets a point at the start where the surface's chart is singular, near alpha = \(1e-05, 0\)>
%! cone = surface_functions (struct ("name", "cone", "half_angle", 1));
%! refuse_singular (cone, struct ("alpha1", [1; 1e-5], "alpha2", [0; 0]), "at the start");
%!error <the rod leaves the chart at t = 1: the surface has no metric there>
%! cone = surface_functions (struct ("name", "cone", "half_angle", 1));
%! refuse_singular (cone, struct ("alpha1", [1; NaN], "alpha2", [0; 0]), "at t = 1");
%!error <the rod leaves the chart at the start: the surface has no metric there>  # a cylinder that is a line
%! line = surface_functions (struct ("name", "cylinder", "radius", 0));
%! refuse_singular (line, struct ("alpha1", [0; 1], "alpha2", [0; 0]), "at the start");
%!function refuse (normals, determinant)
%!  surface.normal = @(fields) deal (normals(:,1), normals(:,2), normals(:,3), determinant);
%!  refuse_singular (surface, struct ("alpha1", [1; 2], "alpha2", [3; 4]), "at t = 7");
%!endfunction
%!test # normals of neighbours are less than a right angle apart, and the metric keeps a ten thousandth of itself
%! for k = 1:3
%!   n = eye (3)(k,:);
%!   refuse ([n; n], [1; 1]);
%!   fail ("refuse ([n; -n], [1; 1])", "meets a point at t = 7 where the surface's chart is singular");
%!   fail ("refuse ([n; circshift(n, 1) - 0.1*n], [1; 1])", "chart is singular");
%!   refuse ([n; circshift(n, 1) + 0.1*n], [1; 1]);
%! endfor
%! refuse ([n; n], [1; 1.1e-4]);
%! fail ("refuse ([n; n], [1; 0.9e-4])", 'singular, near alpha = \(2, 4\)');
%! fail ("refuse ([n; n], [1e-5 1; 1 1])", 'singular, near alpha = \(1, 3\)');
