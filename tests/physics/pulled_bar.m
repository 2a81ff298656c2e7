## -*- texinfo -*-
## @deftypefn {} {@var{u} =} pulled_bar (@var{xi}, @var{t}, @var{bar})
## Longitudinal displacement (p-by-m, m) at the stations @var{xi} (p-by-1, m) and times @var{t} (1-by-m, s) of a bar
## that is fixed at one end and pulled at the other one from t = 0 on, by d'Alembert's waves: a front runs to and fro,
## and the displacement of each point is a triangular wave.  @var{bar}: length (m), EA (N), rhoA (kg/m), force (N).
## @end deftypefn

function u = pulled_bar (xi, t, bar)
  c = sqrt (bar.EA/bar.rhoA);
  u = 0*xi*t;
  for n = 0:ceil (c*t(end)/(2*bar.length))
    outward = (2*n + 1)*bar.length;
    u += (-1)^n*(max (c*t - (outward - xi), 0) - max (c*t - (outward + xi), 0));
  endfor
  u *= bar.force/bar.EA;
endfunction

%!function bar = soft_bar ()
%!  bar = struct ("length", 1, "EA", 1e4, "rhoA", 1, "force", 10);
%!endfunction
%!function rod = rod_of (bar)
%!  rod = struct ("length", bar.length, "EA", bar.EA, "EI", 100, "rhoA", bar.rhoA);
%!endfunction
%!function scene = hinged_bar (bar)
%!  scene.rod = rod_of (bar);
%!  scene.force = @(t) [bar.force, 0];
%!  scene = in_time (scene);
%!endfunction
%!function scene = jointed_bar (bar)
%!  scene.bodies = {struct("rod", rod_of (bar))};
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                  struct("kind", "force", "bodies", 1, "stations", bar.length, "value", [bar.force, 0])};
%!  scene = in_time (scene);
%!endfunction
%!function scene = in_time (scene)   # two times to and fro; fronts are at the ends in a frame
%!  [scene.gravity, scene.duration, scene.frames_per_second] = deal (0, 0.08, 500);
%!endfunction
%!function off = off_wave (trial, bar, times)
%!  xi = linspace (0, bar.length, rows (trial.x)).';
%!  off = max (abs (trial.x - xi - pulled_bar (xi, times, bar))(:));
%!endfunction

%!test # the waves are those of the wave equation, with the ends' conditions
%! bar = soft_bar (); h = 1e-4; t = 0.0312;
%! u = pulled_bar ([0 0.4-h 0.4 0.4+h 1-h 1].', t + [-h 0 h]/100, bar);
%! assert (u(1,:), [0 0 0]);
%! assert (diff (u(5:6,2))/h, bar.force/bar.EA, 1e-9);
%! assert (max (pulled_bar (1, linspace (0, 0.04, 1001), bar)), 2*bar.force/bar.EA, 1e-12);

%!test # the chosen rod keeps its triangular wave within the tolerance and near the estimate
%! bar = soft_bar ();
%! scene = hinged_bar (bar);
%! scene.solver.tolerance = 5e-5;
%! evalc ("result = driver (scene, \"output\", \"\");");
%! [trial.x, ~] = centreline (result.model, linspace (0, bar.length, 21), result.history, 1);
%! off = off_wave (trial, bar, result.history.t);
%! assert (off <= 5e-5);
%! assert (result.summary.estimated_error_m/off > 0.3 && result.summary.estimated_error_m/off < 10);

%!test # so does the chosen mechanism
%! bar = soft_bar ();
%! scene = jointed_bar (bar);
%! [scene.duration, scene.solver.tolerance] = deal (0.042, 4e-4);
%! evalc ("result = driver (scene, \"output\", \"\");");
%! body = result.history.bodies;
%! trial.x = body_centreline (result.model.models{1}, linspace (0, bar.length, 11), body, 1);
%! off = off_wave (trial, bar, result.history.t);
%! assert (off <= 4e-4);
%! assert (result.summary.estimated_error_m/off > 0.3 && result.summary.estimated_error_m/off < 10);
%!test # and one of a few functions is as far from the waves as from one of a few more: not four times as far
%! bar = soft_bar ();
%! scene = check_mechanism (jointed_bar (bar));
%! [scene.duration, scene.solver.tolerance] = deal (0.042, 1e-5);
%! trial_of = @(n) run_model (mechanism_kind (), scene, build_mechanism (scene, mechanism_rungs (scene, 0, n)));
%! [few, more] = deal (trial_of (2), trial_of (3));
%! off = off_wave (few, bar, frame_times (scene));
%! assert (off < 0.3*bar.force/bar.EA);
%! assert (distance (few, more)/off > 0.5 && distance (few, more)/off < 2);

%!test # two functions are the static elongation of a mechanism's rod: by a force within it, and at its tip
%! bar = soft_bar ();
%! scene = jointed_bar (bar);
%! scene.joints{3} = struct ("kind", "force", "bodies", 1, "stations", 0.4, "value", [3, 0]);
%! scene = check_mechanism (scene);
%! system = mechanism_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0, 1)));
%! q = equilibrium (mechanism_at_rest (scene, system.mechanism), 0);
%! [x, y] = body_centreline (system.mechanism.models{1}, [0.2 0.4 0.7 1], struct ("V", q(1:3), "phi", q(4), ...
%!                                                                                "x", q(5), "y", q(6)), 1);
%! assert (x, [0.2 0.4 0.7 1].' + [13*0.2, 13*0.4, 5.2 + 3, 5.2 + 6].'/bar.EA, 1e-12);
%!test # a mass at the end, small as it is, pulls there: one function beside the sines
%! rung = struct ("sines", [], "bending", 0, "longitudinal", 1, "axial", "dynamic", "stiffening", "none");
%! scene = rmfield (hinged_bar (soft_bar ()), "force");
%! scene.model.energy = "uniaxial";
%! for mass = [0 0.01]
%!   base = build_model (check_scene (setfield (scene, "tip_mass", mass)), rung).base;
%!   assert (any (base.longitudinal == -1), mass > 0);
%! endfor
