## -*- texinfo -*-
## @deftypefn {} {[@var{found}, @var{more}, @var{err}] =} best_run (@var{kind}, @var{scene}, @var{name}, @var{exact})
## The run of a checked @var{scene} named @var{name} by the model that is chosen for it (see @code{run_chosen}), or,
## where @var{exact} is "auto" and none fits, by the geometrically exact rod, where that has the smaller estimated
## error: a struct of kind, scene, run and summary, with the options @var{more} that ask the driver for it; or the error
## @var{err} that ended it ([] where none did).
## @end deftypefn

function [found, more, err] = best_run (kind, scene, name, exact)
  more = why_not = exact_scene = {};
  if (strcmp (exact, "auto"))
    exact_scene = kind.exactly (scene);
  endif
  exact_too = ! isempty (exact_scene);
  [found, unfit, err] = model_run (kind, scene, name, exact_too);
  if (exact_too && ! isempty (unfit))
    say ("%s: %s: the geometrically exact rod (EXACT=no: none)", name, unfit);
    [richer, why_not] = exact_run (kind.of_exact (exact_scene), exact_scene, name);
    if (isempty (err) && isempty (found) && (isempty (richer) || estimate_of (richer) > scene.solver.tolerance))
      [found, ~, err] = model_run (kind, scene, name);
    endif
    if (! isempty (richer) && (isempty (found) || estimate_of (richer) < estimate_of (found)))
      [found, more, err] = deal (richer, {"exact", true}, []);
    elseif (! isempty (richer))
      why_not = {sprintf("the geometrically exact rod's estimated error is %.2g m: it was not taken", ...
                         estimate_of (richer))};
    endif
  endif
  if (isempty (err))
    found.summary.warnings = [found.summary.warnings, why_not];
  elseif (strcmp (err.identifier, "toolchain:integration:steep"))
    err = with_remedy (err, [why_not, {kind.instead(scene)}]{1});
  endif
endfunction

function metres = estimate_of (found)
  metres = Inf;
  if (! isempty (found))
    metres = [found.summary.estimated_error_m, Inf](1);
  endif
endfunction

## empty where it was not run, or ended with the error
function [found, unfit, err] = model_run (kind, scene, name, exact_too = false, left = @() Inf)
  found = [];
  [run, summary, unfit, err] = run_chosen (kind, scene, name, left, exact_too);
  if (! isempty (summary))
    found = struct ("kind", kind, "scene", scene, "run", run, "summary", summary);
  endif
endfunction

## empty, with a warning, where it fails, or takes more than two minutes
function [found, why_not] = exact_run (kind, scene, name)
  [found, why_not] = deal ([], {});
  began = tic ();
  try
    [found, ~, err] = model_run (kind, scene, name, false, @() 120 - toc (began));
    if (! isempty (err))
      rethrow (err);
    endif
  catch err
    rethrow_others (err, "toolchain:integration", "toolchain:scene");
    why_not = {sprintf("the geometrically exact rod could not be run: %s", strtrim (err.message))};
  end_try_catch
endfunction

%!function scene = bent_rod ()
%!  scene = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.001), "gravity", 0, "duration", 0.4);
%!  scene.moment = @(t) 1.6*sin (pi*t/0.8).^2;
%!  scene.model.energy = "uniaxial";
%!endfunction
%!test # the exact rod where all other models are further off than the tolerance, and only there
%! for row = {1e-6, "auto", "exact body"; 1e-3, "auto", "rod"; 1e-6, false, "rod"}.'
%!   evalc ("result = driver (bent_rod (), 'tolerance', row{1}, 'output', '', 'exact', row{2});");
%!   assert (kind_of (result.scene).name, row{3});
%! endfor
%! evalc ("result = driver (bent_rod (), 'tolerance', 1e-6, 'output', '');");  # by itself
%! assert (result.summary.estimated_error_m <= 1e-6); assert (isfield (result.history, "phi"));
%!function check_without ()
%!  evalc ("result = driver (bent_rod (), 'tolerance', 1e-6, 'output', '');");
%!  assert (kind_of (result.scene).name, "rod");
%!  said = "the geometrically exact rod could not be run: none today";
%!  assert (any (strncmp (result.summary.warnings, said, numel (said))));
%!endfunction
%!test # where it fails the model's numbers are there
%! with_stand_ins ({"equations = exact_equations", "", "scene_error ('none today');"}, @check_without);
%!function result = clamped (varargin)   # soft, under its weight
%!  rod = struct ("length", 1, "EA", 1e6, "EI", 1, "rhoA", 0.1);
%!  scene.bodies = {struct("rod", rod, "model", struct ("energy", "uniaxial"), varargin{:})};
%!  scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0)};
%!  [scene.duration, scene.frames_per_second] = deal (0.1, 50);
%!  scene.solver.tolerance = 1e-5;
%!  evalc ("result = driver (scene, 'output', '', 'exact', 'auto');");
%!endfunction
%!test # bodies, too, are exact where their models drop more than the tolerance, or it is said
%! result = clamped ();
%! assert (result.summary.stiffening, {"exact"}); assert (result.summary.dropped_m, 0);
%! assert (result.summary.estimated_error_m <= 1e-5);
%! result = clamped ("initial", struct ("V2", 1e-3));
%! assert (result.summary.stiffening, {"foreshortening"}); assert (result.summary.dropped_m > 1e-5);
%! assert (any (strncmp (result.summary.warnings, "the estimated error is", 22)));
%!function check_worse ()
%!  kind = struct ("name", "model", "exactly", @(scene) scene, "of_exact", @(exact) struct ("name", "exact"));
%!  for row = {2e-6 4e-6 "model"; 4e-6 2e-6 "exact"; 4e-6 4e-6 "model"}.'
%!    scene = struct ("solver", struct ("tolerance", 1e-6), "error_of", struct ("model", row{1}, "exact", row{2}));
%!    evalc ("[found, more] = best_run (kind, scene, 'of two', 'auto');");
%!    assert (found.kind.name, row{3}); assert (isempty (more), strcmp (row{3}, "model"));
%!    assert (isempty (found.summary.warnings), strcmp (row{3}, "exact"));
%!  endfor
%!endfunction
%!test # of two that are beyond the tolerance the one that is less so
%! summary = "summary = struct ('estimated_error_m', scene.error_of.(kind.name), 'warnings', {{}});";
%! body = ["[run, summary, unfit, err] = deal ([], [], 'it drops all', []); if (! other), " summary " endif"];
%! with_stand_ins ({"[run, summary, unfit, err] = run_chosen", "kind, scene, name, left, other", body}, @check_worse);
