## -*- texinfo -*-
## @deftypefn {} {@var{estimate} =} estimate_error (@var{scene}, @var{model}, @var{choice}, @var{history})
## The estimated error of a chosen @var{model}'s run, against the rod: a struct of
##
## @table @code
## @item metres
## the largest distance of the centreline from that of the richer model of the @var{choice} (see @code{choose_model}),
## moved by what the whole family of models drops
## @item of_choice
## the same without what is dropped
## @item dropped
## the largest distance by which that moves it (see @code{dropped_error}; of a curved rod it is not known: empty)
## @item seconds
## what it took
## @end table
## @end deftypefn

function estimate = estimate_error (scene, model, choice, history)
  start = tic ();
  reference = choice.reference;
  [moved.x, moved.y] = centreline (model, linspace (0, model.length, rows (reference.x)), history, 1);
  estimate.metres = estimate.of_choice = distance (moved, reference);
  estimate.dropped = [];
  if (isempty (scene.rod.curvature))
    dropped = dropped_error (scene, model, history);
    exact = struct ("x", reference.x + dropped.x, "y", reference.y + dropped.y);
    estimate.metres = distance (moved, exact) + dropped.bound;
    estimate.dropped = dropped.metres;
  endif
  estimate.seconds = toc (start);
endfunction

%!test # a rod that does not bend drops nothing
%! scene = check_scene (setfield (setfield (swing (), "duration", 0.1), "solver", "tolerance", 1e-3));
%! rigid = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "none", "stiffening", "none");
%! trial = trial_run (scene, rigid);
%! reference = struct ("x", trial.x + 3e-6, "y", trial.y - 4e-6);
%! estimate = estimate_error (scene, trial.model, struct ("reference", reference), trial.history);
%! assert ([estimate.metres, estimate.of_choice, estimate.dropped], [5e-6 5e-6 0], 1e-12);
