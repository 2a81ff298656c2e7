## -*- texinfo -*-
## @deftypefn {} {[@var{run}, @var{summary}, @var{unfit}, @var{err}] =} run_chosen (@var{kind}, @var{scene}, @
##   @var{name}, @var{left}, @var{other_way})
## The run of a checked @var{scene} named @var{name} by the model that is chosen for it, with its @var{summary} (see
## @code{summarise}), or the error @var{err} that ended it ([] where none did); and why no model is fit for the scene,
## or "".  That ends the choice at once where there is an @var{other_way}, by default not; @var{left} is what
## @code{ladder_of} takes.
## @end deftypefn

function [run, summary, unfit, err] = run_chosen (kind, scene, name, left, other_way = false)
  [run, summary, unfit, err] = deal ([], [], "", []);
  passed = @(dropped) any (dropped > scene.solver.tolerance);
  drops = @(dropped) sprintf ("all its models drop up to %.2g m, the tolerance is %.2g m", dropped, ...
                              scene.solver.tolerance);
  try
    [model, choice] = chosen_model (kind, scene, left, @(trial) other_way && passed (kind.bound (scene, trial)));
    announce (choice);
    if (choice.useless)
      unfit = drops (kind.bound (scene, choice.trial));
      return;
    endif
    cellfun (@(text) say ("warning: %s", text), kind.foreseen (scene, model));
    run = setfield (balanced_run (kind, scene, model, choice, left), "rung", choice.rung);
    choice = sharp_reference (kind, scene, run, choice, left);
  catch err
    if (strcmp (err.identifier, "toolchain:integration:steep"))
      unfit = "its models of small slopes bend too far";
    endif
    return;
  end_try_catch
  summary = summarise (kind, name, scene, run, choice);
  if (passed (summary.dropped_m))
    unfit = drops (summary.dropped_m);
  endif
endfunction

%!function [run, summary, unfit, err] = quiet (kind, scene, varargin)
%!  scene = kind.check (scene);
%!  evalc ("[run, summary, unfit, err] = run_chosen (kind, scene, 'bent', @() Inf, varargin{:});");
%!endfunction
%!test # models that drop more than the tolerance are run, or left for another way
%! rod = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 0.1);  # soft, under its weight
%! scene.bodies = {struct("rod", rod, "model", struct ("energy", "uniaxial"))};
%! scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)};
%! [scene.duration, scene.frames_per_second] = deal (0.1, 50);
%! scene.solver.tolerance = 1e-5;
%! [run, summary, unfit, err] = quiet (mechanism_kind (), scene);
%! assert (err, []); assert (numel (run.history.t), 6); assert (summary.dropped_m > 1e-5);
%! assert (strncmp (unfit, "all its models drop up to", 25));
%! [run, summary, unfit, err] = quiet (mechanism_kind (), scene, true);
%! assert ({run, summary, err}, {[], [], []}); assert (strncmp (unfit, "all its models drop up to", 25));
%!test # what bends too far ends with an error
%! scene = struct ("rod", struct ("length", 1, "EA", 1e6, "EI", 0.01, "rhoA", 0.1), "duration", 1);
%! [run, ~, unfit, err] = quiet (rod_kind (), scene);
%! assert (run, []); assert (unfit, "its models of small slopes bend too far");
%! assert (err.identifier, "toolchain:integration:steep");
