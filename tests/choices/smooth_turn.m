## -*- texinfo -*-
## @deftypefn {} {@var{theta} =} smooth_turn (@var{s}, @var{angle}, @var{rise}, @var{stops})
## An angle that grows from 0 and its rates, [theta, theta_dot, theta_ddot] (rad, s), after the share @var{s} of the
## @var{rise} (s), by a polynomial: to rest at the @var{angle} where it @var{stops}, or on at the steady rate
## angle/rise.
## @end deftypefn

function theta = smooth_turn (s, angle, rise, stops)
  r = min (s, 1);
  if (stops)
    theta = angle*[r^3*(10 - 15*r + 6*r^2), 30*r^2*(1 - r)^2/rise, 60*r*(1 - r)*(1 - 2*r)/rise^2];
  else
    theta = angle*[r^3 - r^4/2 + s - r, (3*r^2 - 2*r^3)/rise, 6*r*(1 - r)/rise^2];
  endif
endfunction

%!test # rates are derivatives; at the start it rests, at the end it has the angle and rests, or goes on
%! for stops = [true false]
%!   at = @(t) smooth_turn (t/2, 0.3, 2, stops);
%!   for t = [0.1 0.7 1.9 2.5]
%!     assert ((at (t + 1e-5) - at (t - 1e-5))(1:2)/2e-5, at (t)(2:3), 1e-8);
%!   endfor
%!   assert (at (0), [0 0 0]); assert (at (2)(2:3), [! stops*0.15, 0], 1e-15);
%! endfor
%! assert (smooth_turn (1.5, 0.3, 2, true), [0.3 0 0], 1e-15);
%! assert (smooth_turn (1.5, 0.3, 2, false), [0.3/2+0.15 0.15 0], 1e-15);
