## -*- texinfo -*-
## @deftypefn {} {[@var{history}, @var{count}] =} run_model (@var{scene}, @var{model}, @var{choice})
## What is observed of the scene's rod (see @code{measure}), and the @var{count} of @code{integrate}.  A model that was
## chosen has a trial run (see @code{choose_model}), which is taken where it has the solver's method.  The solver
## "auto" takes smaller tolerances, where it must, until the energy balance is within 1e-7 of the largest energy.  A
## run that leaves its energy balance is an error.
## @end deftypefn

function [history, count] = run_model (scene, model, choice)
  solver = scene.solver;
  if (! isempty (choice.trial) && any (strcmp (solver.name, {"auto", choice.trial.count.method})))
    [history, count] = deal (choice.trial.history, choice.trial.count);
  else
    solver.tolerance /= [1, 4](1 + ! isempty (choice.trial));
    [history, count] = run_with (scene, model, solver);
  endif
  for attempt = 1:6*strcmp (solver.name, "auto")
    off = max (energy_error (history));
    if (off <= 1e-7)
      break;
    endif
    solver.tolerance *= min (max (1e-7/off, 1e-3), 0.1);
    before = count;
    [history, count] = run_with (scene, model, solver);
    count.seconds += before.seconds;
    count.calls += before.calls;
  endfor
endfunction

function [history, count] = run_with (scene, model, solver)
  times = frame_times (scene);
  system = rod_system (scene, model);
  [states, count] = integrate (system, times, solver);
  history = measure (system, model, times, states);
  watch_balance (history, system, count);
endfunction

%!test # the balance is kept to 1e-7, whatever the tolerance
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [1 3]), ...
%!                                "solver", struct ("name", "auto", "tolerance", 1e-3)));
%! [model, choice] = model_of_scene (scene);
%! assert (max (energy_error (run_model (scene, model, choice))) <= 1e-7);
%!test
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 0]), "solver", "tolerance", 1e-4));
%! [model, choice] = model_of_scene (scene);
%! [history, count] = run_model (scene, model, choice);
%! assert (numel (history.t), 91);
%!error <ode15s stopped at t = .* s of 1.8 s: the energy balance is off by .*; try a smaller tolerance or step, fewer modes>
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [1 3]), ...
%!                                "solver", struct ("name", "ode15s", "tolerance", 1)));
%! [model, choice] = model_of_scene (scene);
%! run_model (scene, model, choice);
