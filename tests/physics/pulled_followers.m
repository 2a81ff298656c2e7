## -*- texinfo -*-
## @deftypefn {} {@var{history} =} pulled_followers (@var{scene}, @var{bending})
## The motion of a @var{scene} of one rod with so many @var{bending} modes, foreshortening and longitudinal modes
## without inertia (see @code{measure}), with the stretch of its tip against the rod's frame as stretch (m) added.
## @end deftypefn

function history = pulled_followers (scene, bending)
  scene = check_scene (scene);
  scene.solver.tolerance = 1e-7;
  rung = struct ("sines", [], "bending", bending, "longitudinal", 0, "axial", "quasistatic", ...
                 "stiffening", "foreshortening");
  trial = trial_run (scene, rung);
  history = trial.history;
  history.stretch = functions_at (trial.model.base, scene.rod.length)*history.V;
endfunction

%!function scene = soft_rod (force)
%!  scene.rod = struct ("length", 2, "EA", 1e5, "EI", 50, "rhoA", 1);
%!  scene.force = force;
%!  [scene.gravity, scene.duration, scene.frames_per_second] = deal (0, 0.5, 20);
%!endfunction
%!function off = off_balance (history)
%!  off = max (abs (history.balance - history.balance(1)))/max (history.U + history.T);
%!endfunction

%!test # a rod at rest that is pulled at its tip, or within: F xi/EA, and half of the force times that as strain energy
%! for station = [2 0.8]
%!   scene = soft_rod (@(t) [100*sin(3*t), 0]);
%!   scene.force_station = station;
%!   history = pulled_followers (scene, 0);
%!   F = 100*sin (3*history.t);
%!   assert (history.tip_x, 2 + F*station/1e5, 1e-11);
%!   assert (history.U, F.^2*station/1e5/2, 1e-9*max (history.U));
%!   assert (history.W, history.U, 1e-9*max (history.U));
%! endfor
%!test # hanging: tip mass, weight and a force
%! scene = soft_rod (@(t) [0, -30]);
%! [scene.gravity, scene.tip_mass, scene.initial.phi] = deal (9.81, 3, -pi/2);
%! history = pulled_followers (scene, 0);
%! assert (history.tip_y, -2 - (30 + 3*9.81 + 9.81)*2/1e5*ones (size (history.t)), 1e-9);
%!test # in steady rotation, with a force that turns with the rod
%! scene = soft_rod (@(t) 40*[cos(5*t), sin(5*t)]);
%! [scene.rotation, scene.tip_mass] = deal (@(t) [5*t, 5, 0], 0.5);
%! history = pulled_followers (scene, 0);
%! assert (history.stretch, ((40 + 0.5*25*2)*2 + 25*2^3/3)/1e5*ones (size (history.t)), 1e-9);
%!test # the energy balance of rods that bend, turn and are pulled as they do, hinged and in a hub
%! force = @(t) [60*sin(9*t), -20 + 40*cos(5*t)];
%! scene = soft_rod (force);
%! [scene.gravity, scene.initial.phi_dot, scene.tip_mass] = deal (9.81, 4, 0.3);
%! history = pulled_followers (scene, 2);
%! assert (off_balance (history) < 1e-7);
%! assert (max (abs (history.stretch)) > 1e-3);
%! scene = soft_rod (force);
%! [scene.gravity, scene.rotation] = deal (9.81, @(t) [3*t^2, 6*t, 6]);
%! assert (off_balance (pulled_followers (scene, 2)) < 1e-7);
%!test # the angular momentum of a spinning rod stays where a force stretches it: with its moment of inertia, J phi_dot
%! scene = soft_rod ([]);
%! scene.force = @(t) 2e3*t^2*[cos(4*t), sin(4*t)]; scene.duration = 0.2; scene.initial.phi_dot = 4;
%! history = pulled_followers (scene, 0);
%! dynamic = struct ("sines", [], "bending", 0, "longitudinal", 6, "axial", "dynamic", "stiffening", "foreshortening");
%! scene = check_scene (scene);
%! scene.solver.tolerance = 1e-7;
%! with_inertia = trial_run (scene, dynamic).history;
%! alone = trial_run (scene, setfield (setfield (dynamic, "axial", "none"), "longitudinal", 0)).history;
%! effect = abs (alone.phi(end) - with_inertia.phi(end));
%! assert (abs (history.phi(end) - with_inertia.phi(end)) < 0.1*effect);
