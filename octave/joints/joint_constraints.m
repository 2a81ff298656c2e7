## -*- texinfo -*-
## @deftypefn {} {@var{c} =} joint_constraints (@var{constraints}, @var{prescribed}, @var{at})
## All @var{constraints} (see @code{list_constraints}) in the markers' motion @var{at}, with what they prescribe at the
## times of its k states (see @code{prescribed_values}): a struct of residual (Phi), rate (Phi_t), velocity
## (Phi_q q' + Phi_t), convection (what Phi'' is without accelerations; constraints-by-k) and gradients (a cell a kind
## of 6 matrices, by the markers' coordinates).
## @end deftypefn

function c = joint_constraints (constraints, prescribed, at)
  blank = zeros (constraints.count, columns (at.x));
  c.residual = c.rate = c.velocity = c.convection = blank;
  c.gradients = cell (1, numel (constraints.kinds));
  for i = 1:numel (constraints.kinds)
    kind = constraints.kinds(i);
    p = kind.first;
    s = kind.second;
    markers = struct ("x_1", at.x(p,:), "y_1", at.y(p,:), "angle_1", at.angle(p,:), ...
                      "x_2", at.x(s,:), "y_2", at.y(s,:), "angle_2", at.angle(s,:));
    rates = {at.x_dot(p,:), at.y_dot(p,:), at.angle_dot(p,:), at.x_dot(s,:), at.y_dot(s,:), at.angle_dot(s,:)};
    convections = {at.x_convection(p,:), at.y_convection(p,:), at.angle_convection(p,:), ...
                   at.x_convection(s,:), at.y_convection(s,:), at.angle_convection(s,:)};
    [markers.x_1_dot, markers.y_1_dot, markers.angle_1_dot, ...
     markers.x_2_dot, markers.y_2_dot, markers.angle_2_dot] = rates{:};
    offset = {kind.offset.*ones(1, columns (at.x))}(1:double (kind.takes_offset));
    g = cell (1, 6);
    [residual, rate, convection, g{:}] = kind.form (markers, prescribed{i}, offset{:});
    velocity = rate;
    for slot = 1:6
      velocity += g{slot}.*rates{slot};
      convection += g{slot}.*convections{slot};
    endfor
    c.residual(kind.rows,:) = residual;
    c.rate(kind.rows,:) = rate;
    c.velocity(kind.rows,:) = velocity;
    c.convection(kind.rows,:) = convection;
    c.gradients{i} = g;
  endfor
endfunction

%!test # rates along a path
%! [system, q, v, h] = sample_state ();
%! of = @(s) system.at (0.1 + s, q + s*v, v).constraints;
%! [back, here, on] = deal (of (-h), of (0), of (h));
%! assert ((on.residual - back.residual)/(2*h), here.velocity, 1e-7);
%! assert ((on.velocity - back.velocity)/(2*h), here.convection, 1e-6);
