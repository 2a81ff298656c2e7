## -*- texinfo -*-
## @deftypefn {} {[@var{phi}, @var{states}] =} swing_pendulum (@var{name}, @var{times}, @var{field}, @var{value})
## The angle @var{phi} and all @var{states} of @code{sample_pendulum} at the @var{times} (s) by the method of that
## @var{name}, with the @var{value} of a @var{field} of its solver, such as "tolerance" or "step".
## @end deftypefn

function [phi, states] = swing_pendulum (name, times, field = "tolerance", value = 1e-8)
  [system, start] = sample_pendulum ();
  solver = struct ("name", name, "tolerance", 1e-8, "step", [], "rho_infinity", 0.9, "baumgarte", 50);
  states = integrate_constrained (system, times, start, setfield (solver, field, value));
  phi = states.q(1,:);
endfunction

%!assert (swing_pendulum ("radau", [0 0.1 0.8])(2:3), pendulum_angle ([0.1 0.8]), 1e-7)
