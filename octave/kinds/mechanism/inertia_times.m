## -*- texinfo -*-
## @deftypefn {} {@var{f} =} inertia_times (@var{mechanism}, @var{d}, @var{a})
## The mass matrices in the states that @var{d} came from (see @code{rod_dynamics}) times @var{a} (n-by-k).
## @end deftypefn

function f = inertia_times (mechanism, d, a)
  f = zeros (size (a));
  for g = 1:numel (mechanism.groups)
    group = mechanism.groups(g);
    b = d.blocks{g};
    n = rows (group.index) - 3;
    A = reshape (a(group.index,:), n + 3, []);
    V = A(1:n,:);
    phi = A(n+1,:);
    x = A(n+2,:);
    y = A(n+3,:);
    mass = group.model.arrays.mass;
    product = [group.model.arrays.mass_matrix*V + b.V_phi.*phi + b.V_x.*x + b.V_y.*y
               sum(b.V_phi.*V, 1) + b.phi_phi.*phi + b.phi_x.*x + b.phi_y.*y
               sum(b.V_x.*V, 1) + b.phi_x.*phi + mass*x
               sum(b.V_y.*V, 1) + b.phi_y.*phi + mass*y];
    f(group.index,:) = reshape (product, [], columns (a));
  endfor
endfunction

%!test # as the matrix
%! [system, q, v] = sample_state ();
%! d = rod_dynamics (system.mechanism, q, v);
%! assert (inertia_times (system.mechanism, d, v), mechanism_matrices (system.mechanism, d)*v, 1e-12);
