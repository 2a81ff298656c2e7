## -*- texinfo -*-
## @deftypefn {} {@var{f} =} rod_convection (@var{mechanism}, @var{q}, @var{v})
## What of the rates of the rods' momenta comes without accelerations, (dM/dt) v, in the states
## @var{q}, @var{v} (n-by-k).
## @end deftypefn

function f = rod_convection (mechanism, q, v)
  f = zeros (size (q));
  for group = mechanism.groups
    convection = group.model.equations.convection (group.model, motion_of_group (group, q, v));
    f(group.index,:) = reshape (convection, [], columns (q));
  endfor
endfunction

%!test # momenta along a path without accelerations
%! [system, q, v, h] = sample_state ();
%! momentum = @(s) inertia_times (system.mechanism, rod_dynamics (system.mechanism, q + s*v, v), v);
%! assert (rod_convection (system.mechanism, q, v), (momentum (h) - momentum (-h))/(2*h), 1e-6);
