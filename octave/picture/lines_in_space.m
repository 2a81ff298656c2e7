## -*- texinfo -*-
## @deftypefn {} {[@var{springs}, @var{forces}] =} lines_in_space (@var{surface})
## From where to where the springs and the forces of a drawing's @var{surface} (see @code{draw_surface_frames}) are
## drawn: structs of x, y, z and to_x, to_y, to_z (rows of one each, a column a frame, m).  A force's arrow ends where
## it acts; the largest one of all frames is a quarter of the surface's extent long.  Of a spring that is longer than
## that extent the end is cut off.
## @end deftypefn

function [springs, forces] = lines_in_space (surface)
  none = zeros (0, columns (surface.rod.x));
  springs = field_or (surface, "springs", struct ("x", none, "y", none, "z", none, ...
                                                  "to_x", none, "to_y", none, "to_z", none));
  acting = field_or (surface, "forces", struct ("x", none, "y", none, "z", none, ...
                                                "F_x", none, "F_y", none, "F_z", none));
  extent = max ([range(surface.patch.x(:)), range(surface.patch.y(:)), range(surface.patch.z(:))]);
  shown = sqrt ((springs.to_x - springs.x).^2 + (springs.to_y - springs.y).^2 + (springs.to_z - springs.z).^2);
  shown = min (1, extent./max (shown, realmin));
  largest = max ([sqrt(acting.F_x.^2 + acting.F_y.^2 + acting.F_z.^2)(:); realmin]);
  for axis = "xyz"
    to = ["to_" axis];
    springs.(to) = springs.(axis) + shown.*(springs.(to) - springs.(axis));
    forces.(["to_" axis]) = acting.(axis);
    forces.(axis) = acting.(axis) - extent/4/largest*acting.(["F_" axis]);
  endfor
endfunction

%!test # half as long where it is half as large
%! surface = sample_surface (2).surface;
%! surface.forces = struct ("x", [1 1], "y", [2 2], "z", [0 0], "F_x", [0 0], "F_y", [3 0], "F_z", [4 -2.5]);
%! [springs, forces] = lines_in_space (surface);
%! assert (size (springs.to_z), [0 2]);
%! assert ([forces.x; forces.y; forces.z], [1 1; 2 - 0.6, 2; -0.8, 0.5], 1e-12);
%! surface.springs = struct ("x", [0 1], "y", [0 1], "z", [0 1], "to_x", [1 1], "to_y", [1 1], "to_z", [1 9]);
%! springs = lines_in_space (surface);  # on a plane of 4 m
%! assert ([springs.to_x; springs.to_y; springs.to_z], [1 1; 1 1; 1 5], 1e-12);
%! assert ([forces.to_x; forces.to_y; forces.to_z], [1 1; 2 2; 0 0]);
