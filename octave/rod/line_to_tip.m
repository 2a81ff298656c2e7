## -*- texinfo -*-
## @deftypefn {} {[@var{phi}, @var{phi_dot}] =} line_to_tip (@var{x}, @var{y}, @var{x_dot}, @var{y_dot}, @var{first})
## The angle (rad) of the line from O to a rod's tip at @var{x}, @var{y} (1-by-m, m), without jumps of 2 pi from one
## near @var{first} on, and its rate (rad/s): phi of a hinged straight rod, whose deflection is 0 at both ends.
## @end deftypefn

function [phi, phi_dot] = line_to_tip (x, y, x_dot, y_dot, first)
  phi = unwrap (atan2 (y, x));
  phi -= 2*pi*round ((phi(1) - first)/(2*pi));
  phi_dot = (x.*y_dot - y.*x_dot)./(x.^2 + y.^2);
endfunction

%!test # a tip that turns once and a half
%! t = 0:0.5:3;
%! [phi, phi_dot] = line_to_tip (2*cos (3*t + 7), 2*sin (3*t + 7), -6*sin (3*t + 7), 6*cos (3*t + 7), 6.5);
%! assert (phi, 3*t + 7, 1e-12); assert (phi_dot, 3 + 0*t, 1e-12);
