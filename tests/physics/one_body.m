## -*- texinfo -*-
## @deftypefn {} {@var{off} =} one_body (@var{modes}, @var{duration}, @var{tolerance})
## The scene `paper' as one body on a revolute joint against the hinged rod, from which the joint was eliminated: the
## largest difference of phi (rad) and tip (m) over all frames.
## @end deftypefn

function off = one_body (modes, duration, tolerance)
  scene = setfield (setfield (paper (), "model", "modes", modes), "duration", duration);
  hinged = check_scene (scene);
  model = build_model (hinged, rung_of_scene (hinged));
  system = hinged_rod (hinged, model);
  times = frame_times (hinged);
  states = integrate (system, times, struct ("name", "waveform", "tolerance", 1e-12));
  reference = measure (system, model, times, states);

  moment = scene.moment;
  free = struct ("duration", duration, "breaks", 0.3);
  free.bodies = {struct("rod", scene.rod, "model", scene.model, "initial", scene.initial)};
  free.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
                 struct("kind", "moment", "bodies", 1, "stations", 0, "value", moment)};
  free.solver.tolerance = tolerance;
  free = check_mechanism (free);
  history = run_model (mechanism_kind (), free, build_mechanism (free, mechanism_rungs (free, 0))).history;
  off = max ([abs(history.bodies.phi - reference.phi), abs(history.bodies.tip_x - reference.tip_x), ...
              abs(history.bodies.tip_y - reference.tip_y)]);
endfunction

%!assert (one_body ([0 0], 1.8, 1e-10) < 1e-9)
%!assert (one_body ([1 2], 0.32, 1e-10) < 1e-9) # across the break
