## -*- texinfo -*-
## @deftypefn {} {[@var{history}, @var{count}, @var{warnings}, @var{start_jacobian}] =} run_mechanism (@var{scene}, @
##   @var{mechanism})
## What is observed of a scene's @var{mechanism} (see @code{measure_mechanism}), the @var{count} of
## @code{integrate_constrained}, what its assembly has to say, and the derivatives of the constraints by the
## coordinates at the start (constraints-by-n).  A run that leaves its energy balance is an error.
## @end deftypefn

function [history, count, warnings, start_jacobian] = run_mechanism (scene, mechanism)
  system = mechanism_system (scene, mechanism);
  [start, warnings] = assemble_mechanism (scene, mechanism, system);
  times = frame_times (scene);
  [states, count] = integrate_constrained (system, times, start, scene.solver);
  history = measure_mechanism (system, times, states);
  watch_balance (history, system, count);
  [~, start_jacobian] = system.matrices (system.at (0, start.q, start.v));
endfunction

%!test # the sample keeps its balance, with springs, dampers and a force
%! [system, ~, scene] = sample_mechanism ([0 1]);
%! scene.solver.tolerance = 1e-6; scene.frames_per_second = 20;
%! [history, ~, ~, jacobian] = run_mechanism (scene, system.mechanism);
%! assert (energy_error (history) < 1e-7);
%! assert (history.D(end) > 0 && history.W(end) != 0);
%! assert (size (jacobian), [system.constraint_count, system.n]);
