## -*- texinfo -*-
## @deftypefn {} {@var{convection} =} marker_convection (@var{mechanism}, @var{q}, @var{v})
## The accelerations of a @var{mechanism}'s markers without those of the coordinates, in the states @var{q}, @var{v}
## (n-by-k): a struct of x, y (m/s^2) and angle (rad/s^2; markers-by-k).
## @end deftypefn

function convection = marker_convection (mechanism, q, v)
  k = columns (q);
  convection.x = convection.y = convection.angle = zeros (mechanism.marker_count, k);
  for group = mechanism.markers
    bodies = numel (group.numbers);
    equations = mechanism.groups(group.group).model.equations;
    [x, y, angle] = equations.marker_convection (motion_of_group (group, q, v), group.marker);
    convection.x(group.numbers,:) = reshape (x, bodies, k);
    convection.y(group.numbers,:) = reshape (y, bodies, k);
    convection.angle(group.numbers,:) = reshape (angle, bodies, k);
  endfor
endfunction

%!test # what rates change by along a motion
%! [system, q, v, h] = sample_state ();
%! rates = @(q) markers_of_states (seen_whole (system.mechanism), q, v);
%! [back, on] = deal (rates (q - h*v), rates (q + h*v));
%! convection = marker_convection (system.mechanism, q, v);
%! assert ((on.x_dot - back.x_dot)/(2*h), convection.x, 1e-6);
%! assert ((on.y_dot - back.y_dot)/(2*h), convection.y, 1e-6);
%! assert ((on.angle_dot - back.angle_dot)/(2*h), convection.angle, 1e-5);
