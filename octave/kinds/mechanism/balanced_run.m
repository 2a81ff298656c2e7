## -*- texinfo -*-
## @deftypefn {} {[@var{history}, @var{count}, @var{warnings}] =} balanced_run (@var{scene}, @var{mechanism}, @
##   @var{trial})
## What @code{run_mechanism} has of a scene's @var{mechanism}, or the run that is in the @var{trial} (see
## @code{mechanism_trial}; []: none), where that is by the scene's solver.  The solver "auto" takes smaller tolerances,
## up to three times, until the energy balance is within 1e-7 of what changes (see @code{energy_error}): implicit
## methods damp what their steps pass over, small as its way may be.
## @end deftypefn

function [history, count, warnings] = balanced_run (scene, mechanism, trial = [])
  if (! isempty (trial) && any (strcmp (scene.solver.name, {"auto", trial.count.method})))
    [history, count, warnings] = deal (trial.history, trial.count, trial.warnings);
  else
    [history, count, warnings] = run_mechanism (scene, mechanism);
  endif
  for attempt = 1:3*strcmp (scene.solver.name, "auto")
    off = max (energy_error (history));
    if (off <= 1e-7)
      break;
    endif
    scene.solver.tolerance *= min (max ((5e-8/off)^2, 1e-3), 0.1);  # what is damped falls about as its square root
    before = count;
    [history, count] = run_mechanism (scene, mechanism);
    count.seconds += before.seconds;
    count.calls += before.calls;
  endfor
endfunction

%!test # a rod that rings: damped by less than its tolerance, but not out of its balance
%! scene = setfield (chain (1), "duration", 0.5);
%! scene.bodies{1}.rod = struct ("length", 1, "EA", 1e6, "EI", 20, "rhoA", 1);
%! scene.bodies{1}.model.modes = [0 2];
%! scene.bodies{1}.initial.V2 = [0 1e-3];
%! scene.solver.tolerance = 1e-3;
%! scene = check_mechanism (scene);
%! mechanism = build_mechanism (scene, mechanism_rungs (scene, 0));
%! assert (max (energy_error (run_mechanism (scene, mechanism))) > 1e-6);
%! assert (energy_error (balanced_run (scene, mechanism)) <= 1e-7);
%!test # a model is chosen by `auto', and then run by the scene's solver, once
%! scene = setfield (chain (1), "duration", 0.02);
%! scene.bodies{1}.model.modes = "auto";
%! scene.solver = struct ("name", "variational", "step", 1e-3, "tolerance", 1e-3);
%! scene = check_mechanism (scene);
%! [mechanism, choice] = mechanism_of_scene (scene);
%! [~, count] = balanced_run (scene, mechanism, choice.trial);
%! assert (count.method, "variational"); assert (choice.trial.count.method, "radau");
%! scene.solver.name = "auto";
%! [history, count] = balanced_run (scene, mechanism, choice.trial);
%! assert (history, choice.trial.history); assert (count, choice.trial.count);
