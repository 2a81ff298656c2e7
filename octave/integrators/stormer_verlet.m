## -*- texinfo -*-
## @deftypefn {} {@var{stepper} =} stormer_verlet (@var{system}, @var{h}, @var{solver})
## Stoermer and Verlet's method in steps of @var{h} (s), for @code{integrate_fixed}: half a step of the momenta, a step
## of the coordinates, half a step of the momenta.  Where the kinetic energy depends on the coordinates, their
## equations are solved by iteration, so that the method is symplectic and symmetric (Hairer, Lubich and Wanner, Acta
## Numerica 12, 2003, (1.23)).
## @end deftypefn

function stepper = stormer_verlet (system, h, solver)
  momenta = system.momenta;
  n = rows (system.mass);
  stepper = struct ("form", momenta.form, "state", momenta.state, "step", @(t, z) step (t, z, h, n, momenta.rate));
endfunction

function [z, converged] = step (t, z, h, n, rate)
  x = 1:n;
  P = n+1:2*n;
  rest = 2*n+1:numel (z);
  start = z;
  [z, first] = settled (z, P, @(here) start(P) + h/2*rate (t, here)(P));
  before = rate (t, z);
  middle = z;
  z(x) += h*before(x);
  [z, second] = settled (z, x, @(here) middle(x) + h/2*(before(x) + rate (t + h, here)(x)));
  after = rate (t + h, z);
  z(P) += h/2*after(P);
  z(rest) += h/2*(before(rest) + after(rest));
  converged = first && second;
endfunction

## z(part) = f (z)
function [z, converged] = settled (z, part, f)
  for sweep = 1:50
    last = z(part);
    z(part) = f (z);
    if (norm (z(part) - last) <= 1e-14*norm (z(part)))
      break;
    endif
  endfor
  converged = sweep < 50 || ! all (isfinite (z));
endfunction

%!test # an oscillator: what the method's matrix gives
%! rate = @(t, z) [z(2); -9*z(1); 0];
%! system = struct ("mass", 1, "momenta", struct ("rate", rate, "form", @(y) y, "state", @(z) z));
%! h = 0.1;
%! z = stormer_verlet (system, h, struct ()).step (0, [1; 2; 0]);
%! assert (z(1:2), [1, 0; -9*h/2, 1]*[1, h; 0, 1]*[1, 0; -9*h/2, 1]*[1; 2], 1e-13);
%!function z_dot = counted (calls, z)
%!  calls("all") += 1;
%!  z_dot = [z(2); -9*z(1); 0];
%!endfunction
%!test # an oscillator takes no call that nobody reads: two and one until the equations settle, and two
%! calls = containers.Map ("all", 0);
%! rate = @(t, z) counted (calls, z);
%! system = struct ("mass", 1, "momenta", struct ("rate", rate, "form", @(y) y, "state", @(z) z));
%! stormer_verlet (system, 0.1, struct ()).step (0, [1; 2; 0]);
%! assert (calls("all"), 5);
%!test # what is integrated beside goes by the trapezoidal rule: a power of 6 t + 1, from t = 2
%! system = struct ("mass", 1, "momenta", struct ("rate", @(t, z) [0; 0; 6*t+1], "form", @(y) y, "state", @(z) z));
%! z = stormer_verlet (system, 0.5, struct ()).step (2, [1; 0; 5]);
%! assert (z, [1; 0; 5 + 3*(2.5^2 - 2^2) + 0.5], 1e-13);
