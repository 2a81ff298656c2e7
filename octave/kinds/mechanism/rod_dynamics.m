## -*- texinfo -*-
## @deftypefn {} {@var{d} =} rod_dynamics (@var{mechanism}, @var{q}, @var{v})
## The free rods' equations in the states @var{q}, @var{v} (n-by-k): a struct of force (n-by-k, generalized forces: of
## weight, stiffness, damping and motion), dissipated (1-by-k, W) and blocks (a cell a group, of what its mass
## matrices need; see @code{matrix_equations}).
## @end deftypefn

function d = rod_dynamics (mechanism, q, v)
  k = columns (q);
  d.force = zeros (mechanism.n, k);
  d.dissipated = zeros (1, k);
  d.blocks = cell (1, numel (mechanism.groups));
  for g = 1:numel (mechanism.groups)
    group = mechanism.groups(g);
    motion = motion_of_group (group, q, v);
    [force, dissipated, d.blocks{g}] = group.model.equations.dynamics (group.model, motion, mechanism.gravity);
    d.force(group.index,:) = reshape (force, [], k);
    d.dissipated += sum (reshape (dissipated, columns (group.index), k), 1);
  endfor
endfunction

%!test # power of free rods: the rate of T + U + Z is minus what is dissipated
%! [system, q, v, h] = sample_state ();
%! d = rod_dynamics (system.mechanism, q, v);
%! a = mechanism_matrices (system.mechanism, d) \ d.force;
%! E = @(s) sum (mechanism_energies (system.mechanism, q + s*v + s^2/2*a, v + s*a));
%! assert ((E (h) - E (-h))/(2*h), -d.dissipated, 1e-3*d.dissipated);
