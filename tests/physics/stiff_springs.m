## -*- texinfo -*-
## @deftypefn {} {[@var{tip}, @var{steps}] =} stiff_springs (@var{kind}, @var{stiffness}, @var{solver})
## Two rods of 1 m and 1 kg, let go from the horizontal, the second on the first by a joint of this @var{kind}, or with
## a @var{stiffness} (N/m or N m/rad), by a spring and damper in its place: "weld" by a torsion spring, "revolute" by a
## bushing.  Where its far end is after 0.5 s (2-by-1, m), and the steps of the @var{solver}.  The damper's time is 1
## ms.
## @end deftypefn

function [tip, steps] = stiff_springs (kind, stiffness = Inf, solver = struct ("name", "radau", "tolerance", 1e-7))
  rod = struct ("length", 1, "EA", 1e6, "EI", 20, "rhoA", 1);
  body = struct ("rod", rod, "model", struct ("modes", [0 0]));
  scene.bodies = {body, body};
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
  joint = struct ("kind", kind, "bodies", [1 2], "stations", [1 0]);
  spring = setfield (setfield (joint, "stiffness", stiffness), "damping", 1e-3*stiffness);
  if (stiffness == Inf)
    scene.joints{2} = joint;
  elseif (strcmp (kind, "weld"))
    scene.joints(2:3) = {setfield(joint, "kind", "revolute"), setfield(spring, "kind", "torsion_spring")};
  else
    scene.joints{2} = setfield (spring, "kind", "bushing");
  endif
  scene.duration = 0.5;
  scene = check_mechanism (scene);
  mechanism = build_mechanism (scene, mechanism_rungs (scene, [0 0]));
  system = mechanism_system (scene, mechanism);
  [states, count] = integrate_constrained (system, [0 0.5], assemble_mechanism (scene, mechanism, system), solver);
  q = states.q(index_of (mechanism, 2),2);
  [tip, steps] = deal (q(2:3) + [cos(q(1)); sin(q(1))], count.steps);
endfunction

%!test # the stiffer the spring, the nearer it is to its joint, in hardly more steps
%! for kind = {"weld", "revolute"}
%!   joint = stiff_springs (kind{1});
%!   [soft, steps] = stiff_springs (kind{1}, 1e5);
%!   [stiff, hardly_more] = stiff_springs (kind{1}, 1e7);
%!   [stiffest, nor_more] = stiff_springs (kind{1}, 1e9);
%!   assert (norm (stiff - joint) < 0.02*norm (soft - joint));
%!   assert (norm (stiffest - joint) < 1e-6);
%!   assert ([hardly_more, nor_more] <= 1.5*steps);
%! endfor
%!test # methods of equal steps take them, too, in steps of five undamped periods of the springs and more
%! for name = {"generalized_alpha", "variational"}
%!   solver = struct ("name", name{1}, "tolerance", 1, "step", 0.01, "rho_infinity", 0.8);
%!   assert (stiff_springs ("weld", 1e7, solver), stiff_springs ("weld"), 1e-3);
%! endfor
