## -*- texinfo -*-
## @deftypefn {} {@var{f} =} inertia_times (@var{mechanism}, @var{d}, @var{a})
## The mass matrices in the states that @var{d} came from (see @code{rod_dynamics}) times @var{a} (n-by-k).
## @end deftypefn

function f = inertia_times (mechanism, d, a)
  f = zeros (size (a));
  for g = 1:numel (mechanism.groups)
    group = mechanism.groups(g);
    A = reshape (a(group.index,:), rows (group.index), []);
    f(group.index,:) = reshape (group.model.equations.inertia (group.model, d.blocks{g}, A), [], columns (a));
  endfor
endfunction

%!test # as the matrix
%! [system, q, v] = sample_state ();
%! d = rod_dynamics (system.mechanism, q, v);
%! assert (inertia_times (system.mechanism, d, v), mechanism_matrices (system.mechanism, d)*v, 1e-12);
