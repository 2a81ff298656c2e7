## -*- texinfo -*-
## @deftypefn {} {@var{table} =} constrained_stability ()
## What the integrators of mechanisms do to constraints, for the table of @code{stability} (method, what, predicted,
## measured): how Phi'' = 0 alone drifts with time, the limit of Baumgarte's terms in explicit steps, and the condition
## of the matrix of Newton's iteration on index 3 as the step goes to 0, of the scene double_pendulum, as it stands and
## scaled as @code{index3_alpha} takes it.
## @end deftypefn

function table = constrained_stability ()
  times = 1:12;
  drift = cummax (constraint_drift ("acceleration", struct ("step", 0.05), times, 9.81));
  power = polyfit (log (times(4:end)), log (drift(4:end)), 1)(1);
  rows = {"acceleration", "power of time by which Phi drifts", 2, power};
  limit = real_limit ("ode45");
  ## a root that is double: what is off grows as the number of steps at the limit
  stable = @(hr) constraint_drift ("baumgarte", struct ("step", 0.01, "baumgarte", hr/0.01), 1, 0.01, 1e-6) < 1e-4;
  rows(end+1,:) = {"baumgarte", "limit of step times rate, ode45", limit, measured_limit(stable, limit)};
  [scene, kind] = checked_scene ("double_pendulum", {});
  system = started_system (kind, scene, kind.build (scene, kind.stated (scene)));
  rows = [rows; newton_condition(system, named_rows (system, system.initial_state), 10.^(-2:-2:-6))];
  table = cell2struct (rows, {"method", "what", "predicted", "measured"}, 2).';
endfunction

## a rod that swings about a pin at its tip, which it is off by so much at the start (m)
function drift = constraint_drift (method, solver, times, gravity, off = 0)
  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1), "model", struct ("modes", [0 0]))};
  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 1)};
  [scene.duration, scene.gravity] = deal (times(end), gravity);
  scene = check_mechanism (scene);
  system = assembled_system (scene, build_mechanism (scene, mechanism_rungs (scene, 0)));
  system.initial_state(system.n) += off;
  solver.name = method;
  solver.tolerance = 1;
  drift = Inf (size (times));
  try
    states = named_rows (system, integrate (system, [0 times], solver));
    residual = system.at ([0 times], states.q, states.v).constraints.residual;
    drift = hypot (residual(1,2:end), residual(2,2:end));
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
  end_try_catch
endfunction

%!test # Newton's matrix grows worse as h goes to 0 unless it is scaled
%! table = constrained_stability ();
%! measured = [table.measured];
%! assert (measured(1), 2, 0.1);
%! assert (measured(2), table(2).predicted, 0.01*table(2).predicted);
%! assert (measured(7) > 1e6*measured(3)); assert (measured(8) < 10*measured(4));
