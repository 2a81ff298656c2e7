## -*- texinfo -*-
## @deftypefn {} {@var{found} =} at_state (@var{kind}, @var{scene}, @var{t})
## The state at the time @var{t} (s) of the run of a checked scene of a @var{kind} (see @code{kind_of}), with the modes
## that it states, or is given by @code{choose} up to then, and what vibrates about it with its coefficients frozen
## (see @code{linearised_motion}): a struct as of @code{at_rest}, with v, the velocities; functions and change are
## those of stated modes.
##
## What oscillates has a damping ratio, also a negative one, as its amplitude changes on the way; rate is that of what
## goes away without.
## @end deftypefn

function found = at_state (kind, scene, t)
  if (t > scene.duration)
    scene_error ("time is %g: it takes a time in s, up to the duration, %g s", t, scene.duration);
  endif
  [model, state] = state_of_run (kind, scene, t);
  balance = kind.at_rest (scene, model);
  n = balance.n;
  found = struct ("time", t, "balance", balance, "q", state(1:n), "v", state(n+1:2*n), "functions", NaN);
  found.linear = linearised_motion (balance, t, found.q, found.v);
  refuse_negative_mass (found.linear, sprintf ("at t = %g s", t));
  found.vibrations = vibrations (found.linear);
  found.vibrations.rate(found.vibrations.omega > 0) = 0;
  found.change = NaN (size (found.vibrations.omega));
endfunction

## of a model that is stated, or that is chosen for the way until then
function [model, state] = state_of_run (kind, scene, t)
  if (t == 0)
    model = kind.sized (scene, 4);
    if (! isempty (known_rung (kind, scene)))
      model = chosen_model (kind, scene);
    endif
    state = started_system (kind, scene, model).initial_state;
    return;
  endif
  scene.frames_per_second = ceil (scene.frames_per_second*t)/t;
  scene.duration = t;
  [model, choice] = chosen_model (kind, scene);
  run = choice.trial;
  if (isempty (run))
    run = run_model (kind, scene, model);
  endif
  state = run.end_state;
endfunction

%!function found = found_of (given, t)
%!  scene = scene_of_bodies (given);
%!  kind = kind_of (scene);
%!  found = at_state (kind, kind.check (scene), t);
%!endfunction
%!test # a rigid pendulum of 1 m on its way: omega^2 = -3/2 g sin (phi), until it is above its hinge
%! scene = struct ("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1, "rhoI", 0, "half_height", 0.01), ...
%!                 "duration", 2, "model", struct ("modes", [0 0], "rotary_inertia", false));
%! [scene.initial, scene.solver] = deal (struct ("phi", 0, "phi_dot", 3), struct ("tolerance", 1e-8));
%! found = found_of (scene, 0.7);
%! assert (found.q(1) + 1 < 0); assert (found.vibrations.omega, sqrt (-1.5*9.81*sin (found.q(1))), 1e-4);
%! found = found_of (scene, 0.1);
%! assert (found.q(1) > 0); assert (found.vibrations.rate, sqrt (1.5*9.81*sin (found.q(1))), 1e-4);
%! assert (found.v(1)^2, 9 - 3*9.81*sin (found.q(1)), 1e-5);
%! fail ("found_of (scene, 3)", "time is 3: it takes a time in s, up to the duration, 2 s");
%!test # of a rod on a surface at its start, that lies still: its own vibrations
%! scene = struct ("surface", struct ("name", "plane", "inclination", 0), "duration", 1, "rod", ...
%!                 struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1), "model", struct ("modes", [10 10]));
%! found = found_of (scene, 0);
%! assert (found.vibrations.omega(1:5), [0 0 0 22.37329 61.67282], 1e-2);
