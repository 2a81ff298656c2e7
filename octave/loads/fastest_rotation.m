## -*- texinfo -*-
## @deftypefn {} {@var{speed} =} fastest_rotation (@var{scene})
## The largest angular velocity (rad/s) that the hub of a checked @var{scene} has at 1001 times of its duration.
## @end deftypefn

function speed = fastest_rotation (scene)
  speed = max (abs (at_times (scene.rotation, linspace (0, scene.duration, 1001))(2,:)));
endfunction

%!assert (fastest_rotation (struct ("rotation", @(t) [t - t^2, 1 - 2*t, -2], "duration", 3)), 5)
