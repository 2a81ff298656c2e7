## -*- texinfo -*-
## @deftypefn {} {@var{speed} =} fastest_rotation (@var{rotation}, @var{duration})
## The largest angular velocity (rad/s) that a @var{rotation}, a function of t (s) that returns an angle and its rates,
## has at 1001 times of the @var{duration} (s).
## @end deftypefn

function speed = fastest_rotation (rotation, duration)
  speed = max (abs (at_times (rotation, linspace (0, duration, 1001))(2,:)));
endfunction

%!assert (fastest_rotation (@(t) [t - t^2, 1 - 2*t, -2], 3), 5)
