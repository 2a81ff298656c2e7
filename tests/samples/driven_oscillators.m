## -*- texinfo -*-
## @deftypefn {} {@var{system} =} driven_oscillators ()
## A system to test exponential integrators with: x'' + w^2 x = cos (t) for w = 0, 3 and 1000, from rest, and sin (t)
## by its rate.  The exact x is 1 - cos (t) for w = 0, else (cos (t) - cos (w t))/(w^2 - 1).
## @end deftypefn

function system = driven_oscillators ()
  squares = [0; 3; 1000].^2;
  system = struct ("mass", eye (3), "stiffness_at", @(t, y) diag (squares), "state_scale", ones (7, 1), ...
                   "duration", 4, "longest_step", Inf, "velocity_matrix", eye (3), "initial_state", zeros (7, 1));
  system.rate = @(t, y) [y(4:6,:); cos(t) - squares.*y(1:3,:); cos(t)];
endfunction

%!assert (driven_oscillators ().rate ([0 0], [ones(7, 1), zeros(7, 1)]), ...
%!        [1 1 1 1 -8 -999999 1; 0 0 0 1 1 1 1].')
