## -*- texinfo -*-
## @deftypefn {} {@var{kind} =} kind_of (@var{scene})
## The kind of a @var{scene}, checked or not: a struct of what the kinds do each in its way.  All else is the same for
## every kind.
##
## @table @code
## @item name
## "rod", "curved rod", "mechanism", "surface", "exact" or "exact body"
## @item has (given)
## whether a scene is of this kind
## @item check (given)
## the scene with all its fields, or an error: title, duration, frames_per_second, frame_size, model.modes ("auto" or a
## rung in numbers), solver.name, solver.step, solver.tolerance, in metres, probed, its loads (see @code{load_breaks}),
## and its own
## @item pixel (scene)
## metres of a drawn pixel
## @item models (scene)
## what it says of models: the field model of the scene, or of each of its bodies, a struct array
## @item stated (scene)
## [rung, note]: the rung of the ladder that the scene states, empty where it is to be chosen, and what to say of it
## @item ladder (scene)
## what @code{choose} takes, the solver of its trials (see @code{ladder_of}), and for a chart label (rung), labels, a
## text of what those are, and curve (rung), the name of the rung's curve
## @item far_richer (scene, model)
## a rung far above a model's
## @item build (scene, rung)
## the model
## @item system (scene, model)
## what @code{integrate} takes, with warnings (a cellstr) and energy_rows (those of work and dissipated energy, [] for
## none)
## @item led_by (system, run)
## the system with the motion of a run by a like model as a first guess of its own, where its integrator takes one
## @item observe (scene, model, system, times, states)
## history and points of a run (see @code{run_model}), and what else the kind has; history.residual is a drift of
## constraints
## @item tighter (solver, off)
## the solver, with a smaller tolerance or another method, for a smaller energy balance than @var{off} (see
## @code{balanced_run})
## @item dropped (scene, run, reference)
## what all models of the ladder drop: a struct of metres, x, y and bound (see @code{dropped_error}), or empty
## @item bound (scene, run)
## the same (m) at most, as far as that is known without a further run, or NaN
## @item instead (scene)
## what to take where no model of the ladder will do, a text
## @item foreseen (scene, model)
## warnings that are known before the run, a cellstr
## @item describe (scene, run)
## the summary's own fields, of which model is a text
## @item limits (scene, run)
## what the model holds for, and how much of it the run takes: a struct array of what, limit and reached
## @item warnings (scene, run)
## where the run leaves what its model holds for, a cellstr
## @item columns (scene, run)
## [names, table] of history.csv: names with units, a row a name
## @item drawing (scene, run)
## what @code{draw_pictures} takes, but for panels and spectrum
## @item panels (scene, run)
## those of its history
## @item spectrum (scene, run)
## that below the panels, a struct like that of @code{tip_spectrum}, or empty
## @item rungs (scene, chosen, richer)
## rungs around a chosen one, a cell array, up to a richer one
## @item exactly (scene)
## [exact, lacks]: the checked scene of geometrically exact rods, or empty and what that lacks
## @item of_exact (exact)
## the kind of that scene
## @item literal (scene)
## the rung of the paper's sines, 7 + 7, or empty
## @item sized (scene, n)
## the model of size n, so many modes, polynomials or elements of each sort, empty where there is none
## @item at_rest (scene, model)
## the balance of forces that @code{equilibrium} and @code{vibrations} take (see @code{mechanism_at_rest}); one rod has
## it as a body (see @code{scene_at_rest})
## @item turning (scene)
## its steady rotation without weight and loads, as @code{campbell} takes it (see @code{steady_rod}), or an error that
## says why there is none; empty where the kind has none
## @item reference
## the method and the tolerance (m) that integrations are measured against: a cell array
## @end table
## @end deftypefn

function kind = kind_of (scene)
  kinds = kind_table ();
  if (! (isstruct (scene) && isscalar (scene)))
    scene_error ("a scene is a function that returns a struct, not a %s%s", class (scene), ...
                 repmat (" array", 1, numel (scene) > 1));
  endif
  kind = kinds(find (arrayfun (@(kind) kind.has (scene), kinds), 1));
endfunction

%!assert (kind_of (paper ()).name, "rod")
%!assert (kind_of (chain (2)).name, "mechanism")
%!assert (kind_of (bowl ()).name, "surface")
%!error <a scene is a function that returns a struct, not a double> kind_of (3)
%!error <a scene is a function that returns a struct, not a struct array> kind_of (struct ("duration", {1 2}))
