## -*- texinfo -*-
## @deftypefn {} {@var{convection} =} constraint_convection (@var{constraints}, @var{prescribed}, @var{at}, @var{c}, @
##   @var{of_markers})
## What Phi'' of the @var{constraints} (see @code{list_constraints}) is without accelerations (constraints-by-k), where
## @var{c} came from @code{joint_constraints} with the same values @var{prescribed} and markers' motion @var{at}, and
## @var{of_markers} from @code{marker_convection}.
## @end deftypefn

function convection = constraint_convection (constraints, prescribed, at, c, of_markers)
  convection = zeros (size (c.residual));
  for i = 1:numel (constraints.kinds)
    kind = constraints.kinds(i);
    p = kind.first;
    s = kind.second;
    markers = struct ("x_1", at.x(p,:), "y_1", at.y(p,:), "angle_1", at.angle(p,:), ...
                      "x_2", at.x(s,:), "y_2", at.y(s,:), "angle_2", at.angle(s,:), ...
                      "x_1_dot", at.x_dot(p,:), "y_1_dot", at.y_dot(p,:), "angle_1_dot", at.angle_dot(p,:), ...
                      "x_2_dot", at.x_dot(s,:), "y_2_dot", at.y_dot(s,:), "angle_2_dot", at.angle_dot(s,:));
    offset = constraint_offset (kind, columns (at.x));
    own = kind.convection (markers, prescribed{i}, offset{:});
    rates = {of_markers.x, of_markers.y, of_markers.angle};
    convection(kind.rows,:) = along_markers (own, kind, c.gradients{i}, rates);
  endfor
endfunction

%!test # what the constraints' velocities change by along a motion
%! [system, q, v, h] = sample_state ();
%! velocity = @(q) system.at (0.1, q, v).constraints.velocity;
%! convection = system.constraint_convection (system.at (0.1, q, v), v);
%! assert ((velocity (q + h*v) - velocity (q - h*v))/(2*h), convection, 1e-6);
