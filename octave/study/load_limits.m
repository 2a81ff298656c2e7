## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} load_limits (@var{which}, @var{options}, @var{left})
## So many times the loads of the scene @var{which}, with the @var{options} (see @code{study_scene}), take its
## stiffness at rest, at the time when they are largest: a row for the table of @code{scene_stability}, predicted by
## @code{buckling_factor} and, where that is below 3, measured along the path of its equilibria, while there are
## seconds @var{left} ().  No row where nothing loads the scene; where it has what no scene at rest takes (see
## @code{scene_at_rest}), or does not come to rest, that is said.
## @end deftypefn

function rows = load_limits (which, options, left)
  rows = struct ("method", {}, "what", {}, "predicted", {}, "measured", {});
  try
    [scene, kind] = study_scene (which, options, @(scene) scene_at_rest (without_solver (scene)));
    [t, size] = heaviest_time (scene);
    if (size == 0)
      return;
    endif
    predicted = buckling_factor (kind, scene, t);
    measured = NaN;
    if (predicted < 3)
      path = load_path (kind, scene, t, [0, 1.2*predicted], @() left ()/2);
      measured = [path.events.factor, NaN](1);
    endif
  catch err
    rethrow_others (err, "toolchain:scene");
    say ("  what loads take its stiffness is not known: %s", strtrim (err.message));
    return;
  end_try_catch
  if (isfinite (predicted))
    rows(1) = struct ("method", "model", "what", sprintf ("times its loads at t = %g s that take its stiffness", t), ...
                      "predicted", predicted, "measured", measured);
  endif
endfunction

function [t, size] = heaviest_time (scene)
  times = linspace (0, scene.duration, 501);
  sizes = zeros (1, 501);
  for load = acting_loads (scene)
    sizes += sum (abs (at_times (load{1}, times)), 1);
  endfor
  [size, heaviest] = max (sizes);
  t = times(heaviest);
endfunction

%!function [rows, said] = of (load)
%!  scene.bodies = {struct("rod", struct ("length", 2, "EA", 1e7, "EI", 10, "rhoA", 1))};
%!  scene.joints = {struct("kind", "weld", "bodies", 1, "stations", 0), ...
%!                  struct("kind", "force", "bodies", 1, "stations", 2, "value", load)};
%!  [scene.gravity, scene.duration] = deal (0, 1);
%!  said = evalc ("rows = load_limits (scene, {'output', ''}, @() 30);");
%!endfunction
%!test # Euler's load, when a force along a column is largest
%! rows = of (@(t) -[5*t^2, 0]);
%! assert ([rows.predicted, rows.measured], [1 1]*pi^2*10/16/5, -1e-4);
%! assert (rows.what, "times its loads at t = 1 s that take its stiffness");
%! rows = of (@(t) -[0.5*sin(pi*t), 0]);
%! assert (rows.predicted, pi^2*10/16/0.5, -1e-4); assert (rows.measured, NaN); # far away
%!test # nothing pulls, nothing buckles
%! assert (numel (of ([5 0])), 0);
%! [rows, said] = of ([0 0]);
%! assert (numel (rows), 0); assert (said, "");
%!test # what no body takes is said, and a solver of one rod is no reason
%! scene = setfield (setfield (swing (), "duration", 0.1), "solver", "name", "rk4");
%! assert (evalc ("load_limits (scene, {'output', ''}, @() 30);"), "");
%! said = evalc ("load_limits (setfield (scene, 'model', 'moment_work', 'chord'), {'output', ''}, @() 30);");
%! assert (! isempty (regexp (said, '^  what loads take its stiffness is not known: .*moment_work')));
