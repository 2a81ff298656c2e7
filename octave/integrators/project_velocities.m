## -*- texinfo -*-
## @deftypefn {} {@var{v} =} project_velocities (@var{system}, @var{t}, @var{q}, @var{v})
## The velocities nearest to @var{v} (n-by-1), in the mass metric, that meet the constraints' rates at the time
## @var{t} (s) in the position @var{q}.
## @end deftypefn

function v = project_velocities (system, t, q, v)
  at = system.at (t, q, v);
  [mass, jacobian] = system.matrices (at);
  v += saddle_solve (system, t, mass, jacobian, 0*v, -at.constraints.velocity);
endfunction

%!test
%! [system, start] = sample_mechanism ([0 1]);
%! v = project_velocities (system, 0, start.q, ones (system.n, 1));
%! assert (system.at (0, start.q, v).constraints.velocity, zeros (5, 1), 1e-12);
