## -*- texinfo -*-
## @deftypefn {} {@var{u} =} curved_statics (@var{kind})
## Displacements of a quarter circle of R = 1 m clamped at O, EI = 2 N m^2, EA = 300 N: "tangent" and "normal" of the
## tip under 1 N along the tangent at O and across it.
## @end deftypefn

function u = curved_statics (kind)
  axis = rod_axis (struct ("length", pi/2, "curvature", 1, "curvature_breaks", []), 32);
  base = base_functions ([1:6, -1], [1:60, -1], pi/2);
  a = curved_arrays (base, axis, struct ("rhoA", 1, "rhoI", 0, "EA", 300, "EI", 2), []);
  n = rows (a.stiffness_matrix);
  tip = curved_functions (base, axis, pi/2);
  [x, y, ~] = undeformed_places (struct ("axis", axis), pi/2);
  turn = -curved_functions (base, axis, 0).chi;  # the clamped tangent at O turns the frame
  direction = [cos(axis.tilt), sin(axis.tilt)];
  if (strcmp (kind, "normal"))
    direction = [-sin(axis.tilt), cos(axis.tilt)];
  endif
  moves = [tip.u_1 - y*turn; tip.u_2 + x*turn];
  q = a.stiffness_matrix \ (direction*moves).';
  u = direction*moves*q;
endfunction

%!test # Castigliano: M = R cos (theta), and M = R (1 - sin (theta)); N = cos, sin
%! assert (curved_statics ("tangent"), pi/4/2 + pi/4/300, -1e-5);
%! assert (curved_statics ("normal"), (3*pi/4 - 2)/2 + pi/4/300, -1e-5);  # without the elongation by a force 1e-4

%!function [scene, model] = semicircle (EI)
%!  scene = arc_pendulum ();
%!  scene.rod = struct ("length", pi/2, "curvature", -2, "EA", 1e4*EI, "EI", EI, "rhoA", 1);
%!  scene.model.modes = [8 40];
%!  scene.zoom = 1;
%!  scene = check_scene (scene);
%!  model = build_curved_model (scene, rung_of_scene (scene));
%!endfunction
%!test # hanging at rest: the change of curvature is M/EI, in closed form
%! [scene, model] = semicircle (50);
%! q = model.arrays.stiffness_matrix \ (9.81*model.arrays.first_moment_1);  # gravity along the frame's x axis
%! [R, l, T] = deal (0.5, pi/2, atan2 (1, 2/pi));  # T: of the tangent at O against the line to the centre of mass
%! y = @(s) R*(sin (s/R)*sin (T) - (1 - cos (s/R))*cos (T));
%! integral = @(s) R*(-R*cos (s/R)*sin (T) - s*cos (T) + R*sin (s/R)*cos (T));
%! s = linspace (0, l, 101);
%! expected = -9.81*(integral (l) - integral (s) - (l - s).*y (s))/50;  # M/EI of the weight beyond s
%! found = curved_functions (model.base, model.base.axis, s).bend*q;
%! assert (found.', expected, 2e-3*max (abs (expected)));
%!test # small oscillations of the stiff semicircle: J = 2 m R^2 about its end, centre of mass at R sqrt (1 + 4/pi^2)
%! scene = semicircle (1e7);
%! period = 2*pi*sqrt (2*0.25/(9.81*0.5*sqrt (1 + 4/pi^2)));
%! scene.initial.phi = -pi/2 + 1e-3;
%! rung = struct ("sines", [0 0], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! model = build_curved_model (scene, rung);
%! scene.duration = period;
%! states = integrate (rod_system (scene, model), [0 period], struct ("name", "ode45", "tolerance", 1e-9));
%! assert (states(1,2), scene.initial.phi, 1e-8);
%!test # two straight halves with a kink are two welded rods
%! [E, l, bend] = deal (struct ("EA", 1e5, "EI", 20, "rhoA", 1), 0.5, 2e-3);
%! rod = setfield (setfield (E, "length", 2*l), "curvature", @(xi) pi/2/bend*(abs (xi - l) < bend/2));
%! rod.curvature_breaks = l + [-1, 1]*bend/2;
%! scene = check_scene (struct ("rod", rod, "duration", 0.2, "model", struct ("modes", [6 16])));
%! model = build_curved_model (scene, rung_of_scene (scene));
%! system = rod_system (scene, model);
%! tilt = model.base.axis.tilt;
%! system.initial_state(rows (model.arrays.mass_matrix) + 1) = -tilt;  # its first half lies level
%! states = integrate (system, [0 0.2], struct ("name", "waveform", "tolerance", 1e-7));
%! history = measure (system, model, [0 0.2], states);
%! body = struct ("rod", setfield (E, "length", l), "model", struct ("modes", "auto", "stiffening", "none"));
%! pair = struct ("bodies", {{body, setfield(body, "initial", struct ("phi", pi/2))}}, "duration", 0.2);
%! pair.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                struct("kind", "weld", "bodies", [1 2], "stations", [l 0])};
%! pair.frames_per_second = 5; pair.solver.tolerance = 1e-6;
%! pair = check_mechanism (pair);
%! welded = run_model (mechanism_kind (), pair, build_mechanism (pair, mechanism_rungs (pair, [6 6], [2 2]))).history;
%! moved = hypot (welded.bodies(2).tip_x(2) - l, welded.bodies(2).tip_y(2) - l);
%! off = hypot (history.tip_x(2) - welded.bodies(2).tip_x(2), history.tip_y(2) - welded.bodies(2).tip_y(2));
%! assert (off < 0.01*moved);
