## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}] =} seen (@var{points}, @var{view})
## The @var{points} (a struct of x, y and z, m) in a camera's plane, z upwards: its @var{view} is a struct of elevation
## and azimuth (degrees), as scene.view has them.
## @end deftypefn

function [x, y] = seen (points, view)
  x = points.y*cosd (view.azimuth) - points.x*sind (view.azimuth);
  y = points.z*cosd (view.elevation) ...
      - (points.x*cosd (view.azimuth) + points.y*sind (view.azimuth))*sind (view.elevation);
endfunction

%!test # from the side, and from above
%! points = struct ("x", 1, "y", 2, "z", 3);
%! [x, y] = seen (points, struct ("elevation", 0, "azimuth", -90));
%! assert ([x, y], [1 3], 1e-15);
%! [x, y] = seen (points, struct ("elevation", 90, "azimuth", -90));
%! assert ([x, y], [1 2], 1e-15);
