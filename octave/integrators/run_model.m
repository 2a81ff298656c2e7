## -*- texinfo -*-
## @deftypefn {} {[@var{history}, @var{count}] =} run_model (@var{scene}, @var{model}, @var{choice})
## What is observed of the scene's rod (see @code{measure}), and the @var{count} of @code{integrate}.  A model that was
## chosen has a trial run (see @code{choose_model}), which is taken where it has the solver's method.
## A run that leaves its energy balance is an error.
## @end deftypefn

function [history, count] = run_model (scene, model, choice)
  solver = scene.solver;
  if (! isempty (choice.trial) && any (strcmp (solver.name, {"auto", choice.trial.count.method})))
    [history, count] = deal (choice.trial.history, choice.trial.count);
    return;
  elseif (! isempty (choice.trial))
    solver.tolerance /= 4;
  endif
  times = frame_times (scene);
  system = rod_system (scene, model);
  [states, count] = integrate (system, times, solver);
  history = measure (system, model, times, states);
  watch_balance (history, system, count);
endfunction

%!test
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [0 0]), "solver", "tolerance", 1e-4));
%! [model, choice] = model_of_scene (scene);
%! [history, count] = run_model (scene, model, choice);
%! assert (numel (history.t), 91);
%!error <ode15s stopped at t = .* s of 1.8 s: the energy balance is off by .*; try a smaller tolerance or step, fewer modes>
%! scene = check_scene (setfield (setfield (paper (), "model", "modes", [1 3]), "solver", struct ("name", "ode15s", "tolerance", 1)));
%! [model, choice] = model_of_scene (scene);
%! run_model (scene, model, choice);
