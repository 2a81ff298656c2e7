## -*- texinfo -*-
## @deftypefn {} {@var{linear} =} held_tangent (@var{balance}, @var{t}, @var{q}, @var{lambda})
## What @code{linearised} returns, but for the damping, which no equilibrium asks for.
## @end deftypefn

function linear = held_tangent (balance, t, q, lambda)
  n = balance.n;
  tangent = balance.tangent (t, q, lambda);
  linear.stiffness = tangent(1:n,:);
  linear.jacobian = tangent(n+1:end,:);
  linear.basis = eye (n);
  if (balance.multipliers > 0)
    linear.basis = null (linear.jacobian);
  endif
  Z = linear.basis;
  linear.mass = balance.mass (q);
  linear.M = Z.'*linear.mass*Z;
  linear.K = Z.'*linear.stiffness*Z;
endfunction

%!test # two masses on springs that a constraint ties together
%! balance = struct ("n", 2, "multipliers", 1, "mass", @(q) diag ([2 3]), "tangent", @(t, q, lambda) [5 0; 0 7; 1 -1]);
%! linear = held_tangent (balance, 0, [0; 0], 0);
%! assert (linear.K/linear.M, 12/5, 1e-12); assert (linear.jacobian*linear.basis, 0, 1e-12);
