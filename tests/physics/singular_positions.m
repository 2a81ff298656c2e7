## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} singular_positions (@var{phi}, @var{phi_dot}, @var{tolerance}, @var{duration})
## The rigid rod four-bar of the IFToMM library of computational benchmark problems: three rods of 1 m and 1 kg, the
## ground between their bearings 1 m, g = 9.81 m/s^2, the outer rods at the angle @var{phi} with the rate
## @var{phi_dot} (from upright with -1 rad/s there).  Wherever all are in line a constraint depends on the others, and
## the motion goes on smoothly.
## @end deftypefn

function scene = singular_positions (phi, phi_dot, tolerance, duration)
  rod = struct ("length", 1, "EA", 1e6, "EI", 1e3, "rhoA", 1);
  rigid = struct ("modes", [0 0]);
  outer = struct ("rod", rod, "model", rigid, "initial", struct ("phi", phi, "phi_dot", phi_dot));
  scene.bodies = {outer, struct("rod", rod, "model", rigid, "initial", struct ("phi", 0)), outer};
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)
                  struct("kind", "revolute", "bodies", [1 2], "stations", [1 0])
                  struct("kind", "revolute", "bodies", [2 3], "stations", [1 1])
                  struct("kind", "revolute", "bodies", 3, "stations", 0, "point", [1 0])};
  scene.duration = duration;
  scene.frames_per_second = 20;
  scene.solver.tolerance = tolerance;
endfunction

%!function phi = exact (phi, phi_dot, times)   # of the parallelogram: (2/3 + 1) phi_ddot = -2 g cos (phi)
%!  options = odeset ("RelTol", 1e-12, "AbsTol", 1e-12);
%!  [~, y] = ode45 (@(t, y) [y(2); -1.2*9.81*cos(y(1))], [times, times(end) + 1], [phi; phi_dot], options);
%!  phi = y(1:end-1,1).';
%!endfunction
%!test # through the line at small tolerances: the parallelogram stays one, and keeps its energy
%! for tolerance = [1e-8 1e-10]
%!   result = driver (singular_positions (0.4, -4, tolerance, 0.2), "output", "", "solver", "radau");
%!   history = result.history;
%!   assert (history.bodies(1).phi, exact (0.4, -4, history.t), 100*tolerance);
%!   assert (history.bodies(2).phi, zeros (1, 5), 1e-9);
%!   assert (history.bodies(3).phi, history.bodies(1).phi, 1e-9);
%!   assert (abs (history.balance - history.balance(1)) < 1e-9*max (history.T));
%! endfor
