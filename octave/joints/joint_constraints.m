## -*- texinfo -*-
## @deftypefn {} {@var{c} =} joint_constraints (@var{constraints}, @var{prescribed}, @var{at})
## All @var{constraints} (see @code{list_constraints}) in the markers' motion @var{at}, with what they prescribe at the
## times of its k states (see @code{prescribed_values}): a struct of residual (Phi), rate (Phi_t), velocity
## (Phi_q q' + Phi_t; constraints-by-k) and gradients (a cell a kind of 6 matrices by the markers' coordinates, empty
## where it is no function of them).
## @end deftypefn

function c = joint_constraints (constraints, prescribed, at)
  blank = zeros (constraints.count, columns (at.x));
  c.residual = c.rate = c.velocity = blank;
  c.gradients = cell (1, numel (constraints.kinds));
  for i = 1:numel (constraints.kinds)
    kind = constraints.kinds(i);
    p = kind.first;
    s = kind.second;
    markers = struct ("x_1", at.x(p,:), "y_1", at.y(p,:), "angle_1", at.angle(p,:), ...
                      "x_2", at.x(s,:), "y_2", at.y(s,:), "angle_2", at.angle(s,:));
    g = cell (1, 6);
    offset = constraint_offset (kind, columns (at.x));
    [residual, rate, g{kind.coordinates}] = kind.form (markers, prescribed{i}, offset{:});
    c.residual(kind.rows,:) = residual;
    c.rate(kind.rows,:) = rate;
    c.velocity(kind.rows,:) = along_markers (rate, kind, g, {at.x_dot, at.y_dot, at.angle_dot});
    c.gradients{i} = g;
  endfor
endfunction

%!test # velocities are those of the residuals
%! [system, q, v, h] = sample_state ();
%! at = @(q) system.at (0.1, q, v).constraints;
%! [back, here, on] = deal (at (q - h*v), at (q), at (q + h*v));
%! assert ((on.residual - back.residual)/(2*h), here.velocity, 1e-7);
