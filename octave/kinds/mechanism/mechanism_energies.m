## -*- texinfo -*-
## @deftypefn {} {@var{E} =} mechanism_energies (@var{mechanism}, @var{q}, @var{v})
## Kinetic energy, strain energy and energy of gravity of all rods (3-by-k, J) in the states @var{q}, @var{v} (n-by-k).
## @end deftypefn

function E = mechanism_energies (mechanism, q, v)
  E = zeros (3, columns (q));
  for group = mechanism.groups
    bodies = columns (group.index);
    [T, U, Z] = group.model.equations.energies (group.model, motion_of_group (group, q, v), mechanism.gravity);
    E += [sum(reshape (T, bodies, []), 1); sum(reshape (U, bodies, []), 1); sum(reshape (Z, bodies, []), 1)];
  endfor
endfunction

%!test # a column a state
%! [system, q, v] = sample_state ();
%! E = mechanism_energies (system.mechanism, [q, 2*q], [v, v]);
%! assert (E(:,2), mechanism_energies (system.mechanism, 2*q, v), 1e-12);
