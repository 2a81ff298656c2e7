## -*- texinfo -*-
## @deftypefn {} {@var{cases} =} known_answers ()
## Pairs of fields whose answer is known in closed form: rows of what, scene, the function of a result of @code{driver}
## that takes the answer from it, the answer, and what it may be off by.
##
## The rod has l = 1 m, m = 0.2 kg, EA = 1e4 N, EI = 2 N m^2; limits at rest are reached by damping.
## @end deftypefn

function cases = known_answers ()
  [l, m, EA, EI] = deal (1, 0.2, 1e4, 2);
  free = struct ("rod", struct ("length", l, "EA", EA, "EI", EI, "rhoA", m/l, "half_height", 0.01), "gravity", 0, ...
                 "model", struct ("energy", "uniaxial"), "duration", 0.5, "frames_per_second", 20, ...
                 "solver", struct ("tolerance", 1e-6));
  held = setfield (free, "rotation", @(t) [0 0 0]);
  damped = setfield (held, "rod", "damping", 0.2);
  stretching = setfield (damped, "model", struct ("modes", [20 0], "energy", "uniaxial"));
  across = @(scene) setfield (scene, "force", @(t) [0 -0.05]);
  along = @(scene) setfield (scene, "force", @(t) [1 0]);
  heavy = @(scene) setfield (scene, "tip_mass", m);
  rigid = @(scene) setfield (scene, "model", "modes", [0 0]);
  last = @(name) @(result) result.history.(name)(end);
  turning = setfield (setfield (free, "rotation", @(t) [10*t, 10, 0]), "model", "axial", "quasistatic");
  turning.model.modes = [30 0];
  cases = {
    "force and tip mass, rigid: F l/(m l^2/3 + M l^2)", setfield(rigid (heavy (across (free))), "duration", 0.05), ...
      last("phi"), -0.05*l/(m*l^2/3 + m*l^2)*0.05^2/2, 1e-6
    "moment and tip mass, rigid: M/J", setfield(setfield (rigid (heavy (free)), "moment", 0.1), "duration", 0.2), ...
      last("phi"), 0.1/(m*l^2/3 + m*l^2)*0.2^2/2, 1e-7
    "force, tip mass and a held hub, at rest: F l^3/(3 EI)", setfield(across (heavy (damped)), "duration", 4), ...
      last("tip_y"), -0.05*l^3/(3*EI), 1e-5
    "force along and a held hub, at rest: F l/EA", setfield(along (stretching), "duration", 3), ...
      @(result) result.history.tip_x(end) - l, l/EA, 2e-6
    "rotation and tip mass, stretched without inertia: (m/3 + M) omega^2 l^2/EA", heavy(turning), ...
      @(result) hypot(result.history.tip_x(end), result.history.tip_y(end)) - l, (m/3 + m)*100*l^2/EA, 1e-4
    "a torsion spring and a hinge, rigid: sqrt (k/J)", on_spring("revolute", "torsion_spring", 0), ...
      @(result) frequency_of(result.history.t, result.history.bodies.phi), sqrt(3*50/(m*l^2)), 0.05
    "a bushing in the middle, rigid: sqrt (k/m) of its place", on_spring("", "bushing", 0.5), ...
      @(result) frequency_of(result.history.t, result.history.bodies.y), sqrt(50/m), 0.05
  };
endfunction

## a rigid rod, turning at first, on a spring of 50 N/m or N m/rad at a station, and a joint at O
function scene = on_spring (joint, spring, station)
  rod = struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 0.2, "half_height", 0.01);
  scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 0], "rotary_inertia", false))};
  scene.joints = {struct("kind", spring, "bodies", 1, "stations", station, "point", [station 0], "stiffness", 50)};
  if (! isempty (joint))
    scene.joints{2} = struct ("kind", joint, "bodies", 1, "stations", 0);
    scene.bodies{1}.initial.phi_dot = 0.1;
  else
    scene.bodies{1}.initial.y_dot = 0.1;
  endif
  [scene.gravity, scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0, 1, 100, 1e-7);
endfunction

## rad/s, of what swings about 0, from its first to its last crossing
function omega = frequency_of (t, x)
  k = find (x(1:end-1).*x(2:end) < 0);
  crossings = t(k) - x(k).*(t(k+1) - t(k))./(x(k+1) - x(k));
  omega = pi*(numel (crossings) - 1)/(crossings(end) - crossings(1));
endfunction

%!test # all of them
%! for case_of = known_answers ().'
%!   [what, scene, answer_of, answer, off] = case_of{:};
%!   evalc ("result = driver (scene, 'output', '');");
%!   assert (abs (answer_of (result) - answer) <= off, sprintf ("%s: %g", what, answer_of (result)));
%! endfor
