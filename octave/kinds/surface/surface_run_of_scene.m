## -*- texinfo -*-
## @deftypefn {} {[@var{run}, @var{choice}] =} surface_run_of_scene (@var{scene})
## The motion of the rod of a checked scene on its surface (see @code{surface_run}), with the polynomials that
## model.modes states, or, where that is "auto", with the fewest that serve it, which @code{choose} finds.
## @var{choice} is what that returns; where nothing was chosen its trial is empty (see @code{given_choice}).
##
## A trial asks less of the energy balance than a run: where that and the solver are right, the trial is the run.
## @end deftypefn

function [run, choice] = surface_run_of_scene (scene)
  if (isnumeric (scene.model.modes))
    choice = given_choice (scene.model.modes, "");
    run = surface_run (scene, scene.model.modes, 3e-9);
    return;
  endif
  choice = choose (surface_ladder (scene), scene.solver.tolerance);
  run = choice.trial;
  if (! any (strcmp (scene.solver.name, {"auto", run.count.method})) || max (energy_error (run.history)) > 1e-7)
    run = surface_run (scene, choice.rung, 3e-9);
  endif
endfunction

%!test
%! scene = check_surface_scene (setfield (large_swing (), "duration", 0.04));
%! [run, choice] = surface_run_of_scene (scene);
%! assert (energy_error (run.history) <= 1e-7);
%! assert (run.scene.model.modes, choice.rung);
%! [run, choice] = surface_run_of_scene (setfield (scene, "model", "modes", [5 6]));
%! assert (choice.trial, []); assert (run.scene.model.modes, [5 6]);
