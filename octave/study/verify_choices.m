## -*- texinfo -*-
## @deftypefn {} {} verify_choices (@var{scenes})
## Compare the model that each of the @var{scenes} (names, or seeds of @code{random_scene}, in a cell array) gets with
## 30 bending + 30 longitudinal modes and foreshortening, integrated fifty times finer: the true error against the
## tolerance and against the estimate, and that of the next smaller rungs.  Prints `ok' or `not ok', a line a scene.
## @end deftypefn

function verify_choices (scenes)
  for which = scenes
    verify_choice (which{1});
  endfor
endfunction

function verify_choice (which)
  if (isnumeric (which))
    [scene, name] = deal (random_scene (which), sprintf ("random %d", which));
  else
    [scene, name] = load_scene (which);
  endif
  scene = check_scene (scene);
  tolerance = scene.solver.tolerance = tolerance_in_metres (scene);
  choice = choose_model (scene);
  rich = struct ("sines", [], "bending", 30, "longitudinal", 30, "axial", "dynamic", "stiffening", "foreshortening");
  start = tic ();
  reference = trial_run (setfield (scene, "solver", "tolerance", tolerance/50), rich);
  true_error = distance (choice.trial, reference);
  smaller = Inf;
  for part = {"axial", "bending", "stiffening"}
    rung = smaller_rung (choice.trial.rung, part{1}, scene);
    if (! isequal (rung, choice.trial.rung))
      smaller = min (smaller, distance (trial_run (scene, rung), reference));
    endif
  endfor
  ratio = choice.error/max (true_error, realmin);
  within = true_error <= tolerance && smaller > 0.95*tolerance && ...
      ((ratio >= 0.3 && ratio <= 10) || true_error < tolerance/20);
  printf (["%s %s: %s, error %.3g of the tolerance, estimate/error %.2f, next smaller rung %.3g;" ...
           " reference %.0f s\n"], {"not ok", "ok"}{1 + within}, name, rung_name (choice.trial.rung), ...
          true_error/tolerance, ratio, smaller/tolerance, toc (start));
endfunction

%!test # the rod that swings
%! text = evalc ("verify_choices ({'swing'})");
%! assert (strncmp (text, "ok swing: rigid, error 0.0", 26));
