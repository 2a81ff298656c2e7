## -*- texinfo -*-
## @deftypefn {} {@var{mode} =} highest_mode (@var{system})
## The fastest oscillation of a system of any kind (see @code{integrate}) about its start, as its own rates have it: a
## struct of omega (rad/s), shape, what it is of the state (n-by-1, a micrometre of the largest coordinate), and
## amplitude (states, from), how much of it is in the difference of two states.  The Jacobian matrix comes from
## differences.
## @end deftypefn

function mode = highest_mode (system)
  y = system.initial_state;
  scale = max (system.state_scale, realmin);
  step = 1e-7*scale;  # where a point is off by 1e-7 m
  n = numel (y);
  for k = 1:n
    change = step(k)*((1:n).' == k);
    jacobian(:,k) = (system.rate (0, y + change) - system.rate (0, y - change))./(2*step(k)*scale);
  endfor
  [vectors, values, lefts] = eig (jacobian.*scale.');
  [mode.omega, k] = max (abs (imag (diag (values))));
  left = lefts(:,k)'./scale.';
  coordinates = 1:rows (system.mass);
  [largest, j] = max (abs (vectors(coordinates,k)));
  mode.shape = 1e-6*scale.*real (vectors(:,k)/vectors(coordinates(j),k));  # at its turning point
  mode.amplitude = @(states, from) abs (left*(states - from));
endfunction

%!test # of the paper's rod without weight: that of its linear oscillation, and its own amplitude
%! [system, scene] = free_rod ([2 2], struct ());
%! mode = highest_mode (setfield (system, "duration", 1));
%! assert (mode.omega, highest_frequency (system), -1e-6);
%! y = system.initial_state;
%! assert (mode.amplitude (y + 2*mode.shape, y), 2*mode.amplitude (y + mode.shape, y), -1e-9);
%!test # of two coordinates of different size it is the linear oscillation, and has nothing of the other
%! K = [90 2; 2 5];
%! scale = [0.01; 3];
%! system = struct ("initial_state", [1; 2; 0; 0], "duration", 1, "state_scale", [scale; scale], "mass", eye (2));
%! system.rate = @(t, y) [y(3:4); -K*(y(1:2) - [1; 2])];
%! mode = highest_mode (system);
%! [shapes, squares] = eig (K);
%! assert (mode.omega, sqrt (squares(2,2)), 1e-6);
%! assert (K*mode.shape(1:2), squares(2,2)*mode.shape(1:2), 1e-6*norm (mode.shape));
%! assert (max (abs (mode.shape(1:2)./scale)), 1e-6, -1e-6);
%! assert (mode.shape(3:4), zeros (2, 1), 1e-6*norm (mode.shape));
%! assert (mode.amplitude ([shapes(:,1); 0; 0], 0) < 1e-6*mode.amplitude ([shapes(:,2); 0; 0], 0));
