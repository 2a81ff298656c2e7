## Steps of the two methods of order 2 for mechanisms: all of what they carry (positions, velocities, work, what
## dissipates) converges with order 2 with springs, dampers, elastic rods and a joint that is driven, and Newton's
## iteration has the right matrix: it takes few evaluations a step.  Held are index3_alpha and variational against
## integrate_radau, with project_velocities, project_positions, saddle_solve, constrained_accelerations, spring_forces
## and integrate_constrained_steps.

%!function [system, start] = driven_arm ()
%!  rod = struct ("length", 0.5, "EA", 1e4, "EI", 20, "rhoA", 1, "damping", 1e-4);
%!  body = struct ("rod", rod, "model", struct ("modes", [0 1], "energy", "uniaxial"));
%!  drive = @(t) [0.2*sin(8*t), 1.6*cos(8*t), -12.8*sin(8*t)];
%!  scene.bodies = {body, body};
%!  scene.joints = {
%!    struct("kind", "revolute", "bodies", 1, "stations", 0)
%!    struct("kind", "angle", "bodies", 1, "stations", 0, "value", drive)
%!    struct("kind", "revolute", "bodies", [1 2], "stations", [0.5 0])
%!    struct("kind", "torsion_spring", "bodies", [1 2], "stations", [0.5 0], "stiffness", 30, "damping", 0.5)
%!    struct("kind", "spring", "bodies", [2 0], "stations", 0.5, "point", [1 -0.5], ...
%!           "stiffness", 200, "damping", 2, "rest", 0.3)
%!    struct("kind", "force", "bodies", 2, "stations", 0.5, "value", @(t) [5*t, 3])};
%!  scene.duration = 0.02;
%!  scene = check_mechanism (scene);
%!  system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, [0 0])));
%!  start = assemble_mechanism (scene, system.mechanism, system);
%!endfunction
%!function at = counted (calls, at, t, q, v)
%!  calls("all") += 1;
%!  at = at (t, q, v);
%!endfunction
%!function ends = end_of (system, start, name, field, value)
%!  solver = struct ("name", name, "tolerance", 1e-10, "step", [], "rho_infinity", 0.8);
%!  states = integrate_constrained (system, [0 0.02], start, setfield (solver, field, value));
%!  ends = [norm(states.q(:,2)), norm(states.v(:,2)), states.W(2), states.D(2)];
%!endfunction
%!test # by index3_alpha and variational
%! most = struct ("generalized_alpha", 5, "variational", 11.5);
%! [system, start] = driven_arm ();
%! reference = end_of (system, start, "radau", "tolerance", 1e-11);
%! calls = containers.Map ("all", 0);
%! at = system.at;
%! system.at = @(t, q, v) counted (calls, at, t, q, v);
%! for name = {"generalized_alpha", "variational"}
%!   off = @(h) end_of (system, start, name{1}, "step", h) - reference;
%!   calls("all") = 0;
%!   coarse = off (1e-3);
%!   assert (calls("all") <= 20*most.(name{1}));
%!   assert (log2 (coarse./off (5e-4)), [2 2 2 2], 0.02);
%! endfor
