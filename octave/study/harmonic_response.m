## -*- texinfo -*-
## @deftypefn {} {@var{H} =} harmonic_response (@var{found}, @var{driven}, @var{into}, @var{hold}, @var{by}, @var{s})
## How outputs answer inputs that go as exp (@var{s} t) about the equilibrium @var{found} (see @code{at_rest}): complex,
## outputs by inputs, a unit of each force, and where it is @var{driven} of its place or angle.  @var{into}, @var{hold}
## and @var{by} are those of @code{with_matrices}.  NaN at @var{s} = 0 where nothing brings a motion back.
##
## With q = Z y + S d, d what is prescribed: Z'(K + s C + s^2 M) (Z y + S d) = Z'F u, solved in coordinates of like
## stiffness: the mass of polynomials, which is nearly singular, is not inverted.
## @end deftypefn

function H = harmonic_response (found, driven, into, hold, by, s)
  linear = found.linear;
  if (s == 0 && any (max (found.vibrations.omega, found.vibrations.rate) == 0))
    H = NaN (rows (by.q), columns (into));
    return;
  endif
  dynamic = linear.stiffness + s*found.balance.damping (found.time, found.q, found.lambda) + s^2*linear.mass;
  q = hold.*driven;
  if (! isempty (linear.M))
    scale = like_stiffness (linear.M, linear.K);
    left = linear.K + s*linear.C + s^2*linear.M;
    right = linear.basis.'*(into - dynamic*q);
    q += linear.basis*(scale.*((scale.*left.*scale.') \ (scale.*right)));
  endif
  lambda = inverse_of (linear.jacobian).'*(into - dynamic*q);
  H = (by.q + s*by.v)*q + by.lambda*lambda + by.u;
endfunction

%!function H = of_two_masses (s, omega)   # on springs of 2 and 3 N/m and a damper, the second mass is driven
%!  found.linear = struct ("M", 2, "C", 0.5, "K", 5, "basis", [1; 0], "stiffness", [5 -3; -3 3], ...
%!                         "mass", diag ([2 1]), "jacobian", [0 1]);
%!  found.balance.damping = @(t, q, lambda) [0.5 0; 0 0];
%!  [found.time, found.q, found.lambda, found.vibrations] = deal (0, [0; 0], 0, struct ("omega", omega, "rate", 0));
%!  by = struct ("q", [1 0; 0 0], "v", zeros (2), "lambda", [0; 1], "u", zeros (2));
%!  H = harmonic_response (found, [false true], [1 0; 0 0], [0 0; 0 1], by, s);
%!endfunction
%!test # its place and what drives it, by a force on the first and by the place of the second; also at rest
%! for s = [0 0.7i 3i]
%!   back = 2*s^2 + 0.5*s + 5;
%!   assert (of_two_masses (s, 1), [1/back, 3/back; 3/back, 9/back - 3 - s^2], 1e-13);
%! endfor
%!assert (of_two_masses (0, 0), NaN (2)); assert (isfinite (of_two_masses (1i, 0)));
