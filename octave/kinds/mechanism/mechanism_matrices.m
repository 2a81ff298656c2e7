## -*- texinfo -*-
## @deftypefn {} {[@var{mass}, @var{jacobian}, @var{spring_jacobian}] =} mechanism_matrices (@var{mechanism}, @
##   @var{d}, @var{at}, @var{c}, @var{springs})
## The mass matrix (n-by-n), Phi_q (constraints-by-n) and the derivatives of the springs' elongations (springs-by-n),
## sparse, in the one state that @var{d}, @var{at}, @var{c} and @var{springs} came from (see @code{rod_dynamics},
## @code{marker_motion}, @code{joint_constraints}).
## @end deftypefn

function [mass, jacobian, spring_jacobian] = mechanism_matrices (mechanism, d, at, c, springs)
  mass = mass_matrix (mechanism, d);
  if (nargout > 1)
    markers = markers_by_coordinates (mechanism, at);
    jacobian = by_markers (mechanism.marker_count, mechanism.constraints, c)*markers;
  endif
  if (nargout > 2)
    spring_jacobian = by_markers (mechanism.marker_count, mechanism.springs, springs)*markers;
  endif
endfunction

function mass = mass_matrix (mechanism, d)
  row = column = value = {};
  for g = 1:numel (mechanism.groups)
    group = mechanism.groups(g);
    b = d.blocks{g};
    [R, bodies] = size (group.index);
    own = zeros (R, R, bodies);
    n = R - 3;
    own(1:n,1:n,:) = repmat (group.model.arrays.mass_matrix, [1 1 bodies]);
    last = [b.V_phi; b.phi_phi; b.phi_x; b.phi_y];
    own(:,n+1,:) = own(n+1,:,:) = reshape (last, R, 1, bodies);
    own(1:n,n+2,:) = own(n+2,1:n,:) = reshape (b.V_x, n, 1, bodies);
    own(1:n,n+3,:) = own(n+3,1:n,:) = reshape (b.V_y, n, 1, bodies);
    own(n+2,n+2,:) = own(n+3,n+3,:) = group.model.arrays.mass;
    own(n+1,n+2,:) = own(n+2,n+1,:) = reshape (b.phi_x, 1, 1, bodies);
    own(n+1,n+3,:) = own(n+3,n+1,:) = reshape (b.phi_y, 1, 1, bodies);
    row{g} = repmat (reshape (group.index, R, 1, bodies), [1 R 1])(:);
    column{g} = repmat (reshape (group.index, 1, R, bodies), [R 1 1])(:);
    value{g} = own(:);
  endfor
  mass = sparse (vertcat (row{:}), vertcat (column{:}), vertcat (value{:}), mechanism.n, mechanism.n);
endfunction

## constraints-by-(3 markers)
function by = by_markers (count, constraints, c)
  by = sparse (constraints.count, 3*count);
  for i = 1:numel (c.gradients)
    kind = constraints.kinds(i);
    g = c.gradients{i};
    for slot = 1:3
      by += sparse (kind.rows, kind.first + (slot - 1)*count, g{slot}, rows (by), columns (by));
      by += sparse (kind.rows, kind.second + (slot - 1)*count, g{slot+3}, rows (by), columns (by));
    endfor
  endfor
endfunction

function by = markers_by_coordinates (mechanism, at)
  count = mechanism.marker_count;
  by = sparse (3*count, mechanism.n);
  for part = at.parts
    part = part{1};
    R = rows (part.index);
    numbers = repmat (part.numbers(:).', R, 1);
    by += sparse ([numbers(:); numbers(:) + count; numbers(:) + 2*count], repmat (part.index(:), 3, 1), ...
                  [part.x_q(:); part.y_q(:); part.angle_q(:)], 3*count, mechanism.n);
  endfor
endfunction

%!test # kinetic energy, and the constraints' rates
%! [system, q, v] = sample_state ();
%! at = system.at (0, q, v);
%! [mass, jacobian] = system.matrices (at);
%! assert (v.'*mass*v/2, mechanism_energies (system.mechanism, q, v)(1), 1e-12);
%! assert (jacobian*v, at.constraints.velocity, 1e-12);
