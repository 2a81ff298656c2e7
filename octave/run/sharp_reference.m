## -*- texinfo -*-
## @deftypefn {} {@var{choice} =} sharp_reference (@var{kind}, @var{scene}, @var{run}, @var{choice}, @var{left})
## The @var{choice} (see @code{choose}) with a reference that tells the error of the @var{run} of its model, by "auto":
## where these are further apart than the tolerance of a checked scene of a @var{kind} (see @code{kind_of}), but the
## reference may have drifted as far by its integration, it is run once more by the run's solver; that is given up
## where it takes more than a third of the seconds @var{left} ().
## @end deftypefn

function choice = sharp_reference (kind, scene, run, choice, left)
  tolerance = scene.solver.tolerance;
  if (isempty (choice.trial) || ! strcmp (run.solver.name, "auto") ...
      || distance (run, choice.reference) <= tolerance || ! (phase_drift (choice.reference) > tolerance))
    return;
  endif
  again = try_rung (ladder_of (kind, scene, left, run.solver), choice.reference.rung, choice.reference);
  row = cellfun (@(rung) isequal (rung, again.rung), {choice.tried.rung});
  choice.tried(row).seconds += again.seconds;
  choice.tried(row).calls += again.count.calls;
  if (isempty (again.error))
    choice.reference = again;
  endif
endfunction

%!function [choice, run, scene] = pendulum ()   # swings for 40 s; a loose reference, by which nothing is told
%!  scene = struct ("rod", struct ("length", 0.4, "width", 0.02, "half_height", 0.005), "duration", 40);
%!  scene.solver.tolerance = 1e-4;
%!  scene = check_scene (scene);
%!  rigid = rung_of_scene (setfield (scene, "model", "modes", [0 0]));
%!  trial = @(tolerance) try_rung (ladder_of (rod_kind (), scene, @() Inf, struct ("name", "auto", "tolerance", ...
%!                                                                                 tolerance)), rigid);
%!  [run, reference] = deal (trial (1e-8), trial (1e-4));
%!  choice = struct ("trial", run, "reference", reference);
%!  choice.tried = struct ("rung", {1, rigid}, "seconds", {0, reference.seconds}, "calls", {0, reference.count.calls});
%!endfunction
%!test
%! [choice, run, scene] = pendulum ();
%! assert (distance (run, choice.reference) > 1e-4);
%! sharp = sharp_reference (rod_kind (), scene, run, choice, @() Inf);
%! assert (distance (run, sharp.reference), 0, 1e-9);
%! assert (sharp.tried(2).calls, choice.tried(2).calls + run.count.calls, 0.2*run.count.calls);
%! same = sharp_reference (rod_kind (), scene, run, choice, @() 1e-6);  # no time is left
%! assert (same.reference, choice.reference);
%! assert (sharp_reference (rod_kind (), setfield (scene, "solver", "tolerance", 1), run, choice, @() Inf), choice);
