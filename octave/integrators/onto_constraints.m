## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{v}] =} onto_constraints (@var{system}, @var{t}, @var{q}, @var{v})
## The states @var{q}, @var{v} (n-by-m) of the times @var{t} (1-by-m, s), which are near to their constraints, moved
## onto them: positions to 1e-11, velocities to 1e-9, a thousand at once.
## @end deftypefn

function [q, v] = onto_constraints (system, t, q, v)
  for first = 1:1000:numel (t)
    some = first:min (first + 999, numel (t));
    [q(:,some), v(:,some)] = moved (system, t(some), q(:,some), v(:,some));
  endfor
endfunction

function [q, v] = moved (system, t, q, v)
  for iteration = 1:4
    at = system.at (t, q, v);
    off = -[at.constraints.residual(:), at.constraints.velocity(:)];
    if (all (abs (off(:,1)) <= 1e-11) && all (abs (off(:,2)) <= 1e-9))
      return;
    endif
    [mass, jacobian] = system.matrices (at);
    c = rows (jacobian);
    unit = full (mean (abs (diag (mass))));
    step = [mass, unit*jacobian.'; unit*jacobian, sparse(c, c)] \ [zeros(numel (q), 2); unit*off];
    q += reshape (step(1:numel (q),1), size (q));
    v += reshape (step(1:numel (q),2), size (q));
  endfor
endfunction

%!test # onto a circle, positions and velocities, with the shortest steps in the mass metric
%! [system, start] = sample_pendulum ();
%! q = start.q + [1e-4 -1e-4; 2e-4 1e-4; 0 3e-4];
%! [moved, v] = onto_constraints (system, [0 0], q, start.v + 1e-3*ones (3, 2));
%! at = system.at ([0 0], moved, v);
%! assert (at.constraints.residual, zeros (2, 2), 1e-11); assert (at.constraints.velocity, zeros (2, 2), 1e-9);
%! assert (abs (moved - q) < 1e-3);
