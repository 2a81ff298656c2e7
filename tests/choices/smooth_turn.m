## -*- texinfo -*-
## @deftypefn {} {@var{turn} =} smooth_turn (@var{angle}, @var{rise}, @var{stops})
## The function @var{turn} (t) of an angle that grows from 0 and its rates, [theta, theta_dot, theta_ddot] (rad, s), in
## the time @var{rise} (s), by a polynomial: to rest at the @var{angle} where it @var{stops}, or on at the steady rate
## angle/rise.  It calls nothing of this folder, which is on the load path while a scene is made, and no longer.
## @end deftypefn

function turn = smooth_turn (angle, rise, stops)
  if (stops)
    course = @(r, s) [r^3*(10 - 15*r + 6*r^2), 30*r^2*(1 - r)^2/rise, 60*r*(1 - r)*(1 - 2*r)/rise^2];
  else
    course = @(r, s) [r^3 - r^4/2 + s - r, (3*r^2 - 2*r^3)/rise, 6*r*(1 - r)/rise^2];
  endif
  turn = @(t) angle*course (min (t/rise, 1), t/rise);
endfunction

%!test # rates are derivatives; at the start it rests, at the end it has the angle and rests, or goes on
%! for stops = [true false]
%!   at = smooth_turn (0.3, 2, stops);
%!   for t = [0.1 0.7 1.9 2.5]
%!     assert ((at (t + 1e-5) - at (t - 1e-5))(1:2)/2e-5, at (t)(2:3), 1e-8);
%!   endfor
%!   assert (at (0), [0 0 0]); assert (at (2)(2:3), [! stops*0.15, 0], 1e-15);
%! endfor
%! assert (smooth_turn (0.3, 2, true) (3), [0.3 0 0], 1e-15);
%! assert (smooth_turn (0.3, 2, false) (3), [0.3/2+0.15 0.15 0], 1e-15);
