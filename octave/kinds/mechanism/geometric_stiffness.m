## -*- texinfo -*-
## @deftypefn {} {@var{K} =} geometric_stiffness (@var{mechanism}, @var{q}, @var{F})
## Minus the derivative by q of the generalized forces that constant forces and moments on the markers have, @var{F} =
## struct of x, y (N), angle (N m; markers-by-k), in the states @var{q} (n-by-k): sparse n-by-n, a block a state along
## the diagonal.
## @end deftypefn

function K = geometric_stiffness (mechanism, q, F)
  states = columns (q);
  K = sparse (mechanism.n*states, mechanism.n*states);
  for group = mechanism.markers
    R = rows (group.index) - 2;
    count = columns (group.index)*states;
    motion = motion_of_group (group, q, 0*q);
    flat = @(x) reshape (x(group.numbers,:), 1, count);
    loads = struct ("force_x", flat (F.x), "force_y", flat (F.y), "force_angle", flat (F.angle));
    [phi_phi, phi_V, V_V] = mechanism.groups(group.group).model.equations.marker_stiffness (motion, loads, group.marker);
    own = zeros (R, R, count);
    own(1:end-1,1:end-1,:) = reshape (V_V, R - 1, R - 1, count);
    own(:,end,:) = own(end,:,:) = reshape ([phi_V; phi_phi], R, 1, count);
    V_and_phi = of_states (group.index(1:end-2,:), mechanism.n, states);
    K -= blocks_at (V_and_phi, own, mechanism.n*states);
  endfor
endfunction

%!test # by differences
%! [system, start] = sample_mechanism ([1 2]);
%! rand ("seed", 5);
%! [q, h] = deal (start.q + 0.01*rand (system.n, 1), 1e-6);
%! F = struct ("x", rand (10, 1), "y", rand (10, 1), "angle", rand (10, 1));
%! forces = @(q) forces_of_markers (system.mechanism, markers_of_states (seen_whole (system.mechanism), q, 0*q), F);
%! K = geometric_stiffness (system.mechanism, q, F);
%! for k = 1:system.n
%!   step = h*(1:system.n == k).';
%!   assert (K(:,k), (forces (q - step) - forces (q + step))/(2*h), 1e-8);
%! endfor
%!test # of two states along the diagonal
%! [system, start] = sample_mechanism ([1 2]);
%! q = start.q + [0 0.1];
%! F = struct ("x", ones (10, 1)*[1 2], "y", ones (10, 1)*[3 4], "angle", zeros (10, 2));
%! of = @(k) geometric_stiffness (system.mechanism, q(:,k), structfun (@(f) f(:,k), F, "uniformoutput", false));
%! assert (of (1:2), blkdiag (of (1), of (2)), 1e-13);
