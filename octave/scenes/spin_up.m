## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} spin_up ()
## The spin-up manoeuvre of Kane, Ryan and Banerjee (1987): a rod clamped in a hub that is brought to 6 rad/s in 15 s.
## The tip lags by 0.57 m and comes back to the line; that takes one or two clamped bending modes, and foreshortening,
## without which the rod loses its stiffness as the hub passes the first frequency (4.4 rad/s here).
## @end deftypefn

function scene = spin_up ()
  scene.title = "Spin-up of a flexible rod, Kane, Ryan and Banerjee (1987)";
  scene.rod.length = 10;
  scene.rod.EA = 2.8e7;
  scene.rod.EI = 1.4e4;
  scene.rod.rhoA = 1.2;
  scene.rod.rhoI = 6e-4;
  scene.gravity = 0;
  scene.rotation = @hub;
  scene.moment_breaks = 15;
  scene.duration = 20;
  scene.frames_per_second = 20;
endfunction

## [theta theta_dot theta_ddot] with theta_dot = 6/15 (t - T sin (t/T)), T = 15/(2 pi), until it is 6
function theta = hub (t)
  T = 15/(2*pi);
  s = min (t, 15);
  theta = 6/15*[s^2/2 + T^2*(cos (s/T) - 1), s - T*sin(s/T), 1 - cos(s/T)];
  theta(1) += 6*(t - s);
endfunction

%!test # the rates are derivatives, and the hub ends at 6 rad/s
%! f = spin_up ().rotation; h = 1e-6;
%! for t = [1 7 14.9 17]
%!   assert ((f (t + h) - f (t - h))(1:2)/(2*h), f (t)(2:3), 1e-6);
%! endfor
%! assert (f (18)(2), 6, 1e-12);
