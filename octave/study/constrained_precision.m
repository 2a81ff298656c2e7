## -*- texinfo -*-
## @deftypefn {} {[@var{table}, @var{write}, @var{draw}] =} constrained_precision (@var{scene}, @var{folder}, @
##   @var{finest}, @var{sizes})
## The work-precision diagram of all integrators of mechanisms on a @var{scene} of several bodies: the error of all
## centrelines' ends and the constraints' drift over all frames against seconds, and the cost of chains beside it.
## The reference is `radau' at 1e-12 m, with which `ode15i' at 1e-9 m (or `daspk': see @code{lacks_sundials}) is
## compared.  What takes more than five minutes is given up; after what took 30 s nothing finer is tried.  Tolerances
## go from 1e-3 m to @var{finest}, steps from 1/100 of the duration to its root; chains have @var{sizes} rods.  It is
## an error, before the work, where the @var{folder} cannot be written.  @var{table} is a struct array of method,
## parameter (tolerance in m, or step in s), error (m), drift (m or rad), seconds, calls, failure; @var{write} (folder)
## writes it, and @var{draw} (scratch) draws it, see @code{publish_study}.
## @end deftypefn

function [table, write, draw] = constrained_precision (scene, folder, finest = 1e-9, sizes = [1 2 5 10 20 50])
  scene = check_mechanism (scene);
  require_folder (folder);
  mechanism = chosen_model (mechanism_kind (), scene);
  system = mechanism_system (scene, mechanism);
  start = assemble_mechanism (scene, mechanism, system);
  times = frame_times (scene);
  run = @(name, parameter) one_run (system, times, start, name, parameter, 300);
  reference = one_run (system, times, start, "radau", 1e-12, Inf);
  second = "ode15i";
  if (lacks_sundials (second))
    second = "daspk";
  endif
  other = one_run (system, times, start, second, 1e-9, Inf);
  printf ("  reference: radau and %s differ by %.2g m\n", second, distance_of (reference, other));
  table = struct ([]);
  for method = usable_methods (constrained_table ())
    parameters = 10.^(-3:-1:log10 (finest));
    if (! method.adaptive)
      parameters = 10.^(-2:-0.5:log10 (finest)/2)*scene.duration;
    endif
    for parameter = parameters
      row = struct ("method", method.name, "parameter", parameter, ...
                    "error", NaN, "drift", NaN, "seconds", NaN, "calls", NaN, "failure", "");
      try
        found = run (method.name, parameter);
        [row.error, row.drift] = deal (distance_of (found, reference), found.drift);
        [row.seconds, row.calls] = deal (found.count.seconds, found.count.calls);
      catch err
        if (! any (strcmp (err.identifier, {"toolchain:integration", "toolchain:scene"})))
          rethrow (err);
        endif
        row.failure = strtrim (err.message);
      end_try_catch
      table = [table, row];
      printf ("  %-18s %-8.2g %8.2g m, drift %8.2g, %7.2f s, %6d calls %s\n", row.method, row.parameter, row.error, ...
              row.drift, row.seconds, row.calls, row.failure);
      if (! (row.seconds < 30))
        break;
      endif
    endfor
  endfor
  cost = chain_cost (sizes);
  write = @(aside) write_constrained_chart (table, cost, aside);
  draw = @(scratch) draw_constrained_chart (table, cost, scene, scratch);
endfunction

function found = one_run (system, times, start, name, parameter, seconds)
  at = system.at;
  clock = tic ();
  system.at = @(varargin) give_up (at (varargin{:}), clock, seconds);
  solver = struct ("name", name, "tolerance", parameter, "step", [], "rho_infinity", 0.8, "baumgarte", 100);
  if (! constrained_table ()(strcmp ({constrained_table().name}, name)).adaptive)
    solver.step = parameter;
  endif
  [states, found.count] = integrate_constrained (system, times, start, solver);
  history = measure_mechanism (system, times, states);
  found.x = [vertcat(history.bodies.x); vertcat(history.bodies.tip_x)];
  found.y = [vertcat(history.bodies.y); vertcat(history.bodies.tip_y)];
  found.drift = max (history.residual);
endfunction

function metres = distance_of (a, b)
  metres = max (hypot (a.x - b.x, a.y - b.y)(:));
endfunction

%!test # a short pendulum: every method comes near the reference
%! scene = struct ("duration", 0.02, "bodies", {{struct("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1), ...
%!                                                      "model", struct ("modes", [0 0]))}});
%! scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0)};
%! folder = tempname (); confirm_recursive_rmdir (false, "local");
%! unwind_protect
%!   evalc ("[table, ~, draw] = constrained_precision (scene, folder, 1e-5, [1 2]);");
%!   assert (cellfun (@isempty, {table.failure}));
%!   assert ([table.error] < 1e-3);
%!   assert (draw_files (folder, {draw}, {"chart.svg", "chart.png"}), cell (0, 2));
%! unwind_protect_cleanup
%!   rmdir (folder, "s");
%! end_unwind_protect
