## -*- texinfo -*-
## @deftypefn {} {@var{phi} =} rigid_pendulum (@var{times}, @var{start}, @var{omega0})
## Angle above the horizontal of a physical pendulum let go at rest at the angle @var{start} (between -pi/2 and pi/2),
## by Jacobi's elliptic functions; @var{omega0} is its frequency of small oscillations.
## @end deftypefn

function phi = rigid_pendulum (times, start, omega0)
  k = sin ((start + pi/2)/2);
  sn = ellipj (omega0*times + ellipke (k^2), k^2);
  phi = 2*asin (k*sn) - pi/2;
endfunction

%!function scene = rigid_scene ()
%!  scene = paper ();
%!  scene.model.modes = [0 0]; scene.solver.tolerance = 1e-12;
%!endfunction

%!test # the rod with no modes is the physical pendulum, to 1e-9
%! scene = rigid_scene (); scene.moment = 0; scene.moment_breaks = []; scene.duration = 5;
%! history = driver (scene, "output", "").history;
%! J = 7800*6e-4*(1/3 + 0.015^2/3); S = 7800*6e-4/2;
%! assert (history.phi, rigid_pendulum (history.t, -pi/6, sqrt (9.81*S/J)), 1e-9);

%!test # driven by the paper's moment: the same as another integrator on the pendulum's equation, to 1e-9
%! history = driver (rigid_scene (), "output", "").history;
%! J = 7800*6e-4*(1/3 + 0.015^2/3); S = 7800*6e-4/2;
%! lsode_options ("relative tolerance", 1e-13); lsode_options ("absolute tolerance", 1e-13);
%! driven = lsode (@(x, t) [x(2); (300*t - 9.81*S*cos (x(1)))/J], [-pi/6; 0], linspace (0, 0.3, 16));
%! free = lsode (@(x, t) [x(2); -9.81*S*cos(x(1))/J], driven(end,:).', history.t(16:91));
%! assert (history.phi, [driven(1:15,1); free(:,1)].', 1e-9);

%!test # a stiff rod moves as the rigid one
%! scene = rigid_scene (); scene.model.modes = [0 1]; scene.duration = 0.2; scene.solver.tolerance = 1e-7;
%! rigid = driver (rigid_scene (), "output", "").history.phi(11);
%! deviation = [0 0];
%! for k = 1:2
%!   scene.rod.lambda = 1.2e11*10^k; scene.rod.mu = 8.1e10*10^k;
%!   deviation(k) = abs (driver (scene, "output", "").history.psi(11) - rigid);
%! endfor
%! assert (deviation(2) < 0.2*deviation(1)); assert (deviation(2) < 1e-4);
