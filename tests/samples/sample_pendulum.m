## -*- texinfo -*-
## @deftypefn {} {[@var{system}, @var{start}] =} sample_pendulum ()
## A mechanism to test integrators with: a rigid rod of 1 m on a revolute joint, let go from the horizontal.  See
## @code{swing_pendulum} and, for its exact motion, @code{pendulum_angle}.
## @end deftypefn

function [system, start] = sample_pendulum ()
  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 2), ...
                         "model", struct ("modes", [0 0]))};
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
  scene.duration = 1;
  scene = check_mechanism (scene);
  system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
  start = struct ("q", zeros (3, 1), "v", zeros (3, 1), "W", 0, "D", 0);
endfunction

%!test # phi_ddot = -3/2 g/l, and so falls its middle
%! [system, start] = sample_pendulum ();
%! a = constrained_accelerations (system, 0, start.q, start.v);
%! assert (a, [-1.5*9.81; 0; 0], 1e-12);
