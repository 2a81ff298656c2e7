## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} mechanism_trial (@var{scene}, @var{rungs})
## Run a checked scene's mechanism with its bodies on the @var{rungs} (see @code{build_mechanism}): a struct of
## mechanism, history, x, y (11 stations of each body by frames, m), count, warnings and seconds.
## @end deftypefn

function trial = mechanism_trial (scene, rungs)
  start = tic ();
  mechanism = build_mechanism (scene, rungs);
  [history, count, warnings] = run_mechanism (scene, mechanism);
  trial = struct ("mechanism", mechanism, "history", history, "x", [], "y", [], "count", count, ...
                  "warnings", {warnings});
  for k = 1:numel (history.bodies)
    model = mechanism.models{k};
    [x, y] = body_centreline (model, linspace (0, model.length, 11), history.bodies(k), 1);
    [trial.x, trial.y] = deal ([trial.x; x], [trial.y; y]);
  endfor
  trial.seconds = toc (start);
endfunction

%!test
%! scene = check_mechanism (setfield (chain (2), "duration", 0.02));
%! trial = mechanism_trial (scene, mechanism_rungs (scene, [0 0]));
%! assert (size (trial.x), [22 2]);
