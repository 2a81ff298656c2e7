## -*- texinfo -*-
## @deftypefn {} {@var{linear} =} linearised (@var{balance}, @var{t}, @var{q}, @var{lambda})
## The equations of a @var{balance} (see @code{mechanism_at_rest}) linear about the state @var{q} (n-by-1) at rest with
## multipliers @var{lambda} at the time @var{t} (s): a struct of M, C and K (p-by-p: M y'' + C y' + K y = 0), basis
## (n-by-p) with q + basis*y, what the constraints leave free (their null space), and mass, stiffness (n-by-n) and
## jacobian (of the constraints) before.
## @end deftypefn

function linear = linearised (balance, t, q, lambda)
  linear = held_tangent (balance, t, q, lambda);
  linear.C = linear.basis.'*balance.damping (t, q, lambda)*linear.basis;
endfunction

%!test # a rigid pendulum of 2 m that hangs: m l^2/3 phi'' + m g l/2 phi = 0
%! scene.bodies = {struct("rod", struct ("length", 2, "EA", 1, "EI", 1, "rhoA", 3), "model", ...
%!                        struct ("modes", [0 0], "rotary_inertia", false), "initial", struct ("phi", -pi/2))};
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%! scene.duration = 1;
%! scene = check_mechanism (scene);
%! balance = mechanism_at_rest (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
%! linear = linearised (balance, 0, balance.start, [0; 0]);
%! assert (linear.K/linear.M, 6*9.81/2/8*2, 1e-10); assert (linear.C, 0);
