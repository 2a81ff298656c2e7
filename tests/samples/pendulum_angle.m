## -*- texinfo -*-
## @deftypefn {} {@var{phi} =} pendulum_angle (@var{t})
## The exact angle of @code{sample_pendulum} at the times @var{t} (s), by the elliptic function:
## phi_ddot = -3/2 g/l cos (phi), from rest at 0.
## @end deftypefn

function phi = pendulum_angle (t)
  omega = sqrt (1.5*9.81);
  [sn, ~, ~] = ellipj (ellipke (0.5) - omega*t, 0.5);
  phi = -pi/2 + 2*asin (sqrt (0.5)*sn);
endfunction

%!test # the equation of motion, by differences
%! h = 1e-4;
%! phi = pendulum_angle (0.3 + [-h 0 h]);
%! assert (diff (phi, 2)/h^2, -1.5*9.81*cos (phi(2)), 1e-5);
%! assert (pendulum_angle (0), 0, 1e-15);
