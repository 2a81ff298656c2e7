## -*- texinfo -*-
## @deftypefn {} {[@var{mass}, @var{jacobian}, @var{spring_jacobian}] =} mechanism_matrices (@var{mechanism}, @
##   @var{d}, @var{at}, @var{c}, @var{springs})
## The mass matrix (n-by-n), Phi_q (constraints-by-n) and the derivatives of the springs' elongations (springs-by-n) in
## the k states that @var{d}, @var{at}, @var{c} and @var{springs} came from (see @code{rod_dynamics},
## @code{marker_motion}, @code{joint_constraints}): sparse, a block a state along the diagonal.
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
  states = columns (d.force);
  mass = sparse (mechanism.n*states, mechanism.n*states);
  for g = 1:numel (mechanism.groups)
    group = mechanism.groups(g);
    index = of_states (group.index, mechanism.n, states);
    mass += blocks_at (index, group.model.equations.mass (group.model, d.blocks{g}), mechanism.n*states);
  endfor
endfunction

## constraints-by-(3 markers), of each state
function by = by_markers (count, constraints, c)
  states = columns (c.residual);
  row = column = value = {};
  for i = 1:numel (c.gradients)
    kind = constraints.kinds(i);
    for coordinate = kind.coordinates
      markers = kind.first;
      if (coordinate > 3)
        markers = kind.second;
      endif
      row{end+1} = of_states (kind.rows(:), constraints.count, states)(:);
      column{end+1} = of_states (markers(:) + mod (coordinate - 1, 3)*count, 3*count, states)(:);
      value{end+1} = c.gradients{i}{coordinate}(:);
    endfor
  endfor
  by = sparse (vertcat (row{:}), vertcat (column{:}), vertcat (value{:}), constraints.count*states, 3*count*states);
endfunction

function by = markers_by_coordinates (mechanism, at)
  [count, states] = size (at.x);
  row = column = value = {};
  for part = at.parts
    part = part{1};
    R = rows (part.index);
    number = of_states (part.numbers(:), 3*count, states)(:).'(ones (1, R),:)(:);
    row{end+1} = [number; number + count; number + 2*count];
    column{end+1} = of_states (part.index, mechanism.n, states)(:)(:,ones (1, 3))(:);
    none = zeros (1, numel (part.numbers)*states);
    filled = @(V, phi, x, y) ([zeros(R - 3, 1) + V + none; phi + none; x; y])(:);
    value{end+1} = [filled(part.x_V, part.x_phi, 1 + none, none); filled(part.y_V, part.y_phi, none, 1 + none)
                    filled(part.angle_V, 1 + none, none, none)];
  endfor
  by = sparse (vertcat (row{:}), vertcat (column{:}), vertcat (value{:}), 3*count*states, mechanism.n*states);
endfunction

%!test # kinetic energy, and the constraints' rates
%! [system, q, v] = sample_state ();
%! at = system.at (0, q, v);
%! [mass, jacobian] = system.matrices (at);
%! assert (v.'*mass*v/2, mechanism_energies (system.mechanism, q, v)(1), 1e-12);
%! assert (jacobian*v, at.constraints.velocity, 1e-12);
%!test # those of several states along the diagonal
%! [system, start] = sample_mechanism ([1 2]);
%! q = start.q + [0, 0.1]; v = [start.v, start.q];
%! together = separate = cell (1, 3);
%! [together{:}] = system.matrices (system.at ([0 0.1], q, v));
%! for k = 1:2
%!   [of_one{1:3}] = system.matrices (system.at (0.1*(k - 1), q(:,k), v(:,k)));
%!   separate = cellfun (@blkdiag, separate, of_one, "uniformoutput", false);
%! endfor
%! cellfun (@(a, b) assert (a, sparse (b), 1e-13), together, separate);
