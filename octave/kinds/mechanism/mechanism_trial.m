## -*- texinfo -*-
## @deftypefn {} {@var{trial} =} mechanism_trial (@var{scene}, @var{rungs})
## Run a checked scene's mechanism with its bodies on the @var{rungs} (see @code{build_mechanism}): a struct of
## mechanism, history, count, warnings and start_jacobian (see @code{run_mechanism}), and the bodies' centrelines x, y
## (see @code{mechanism_points}).
## @end deftypefn

function trial = mechanism_trial (scene, rungs)
  mechanism = build_mechanism (scene, rungs);
  [history, count, warnings, start_jacobian] = run_mechanism (scene, mechanism);
  trial = mechanism_points (mechanism, history);
  trial.mechanism = mechanism;
  trial.history = history;
  trial.count = count;
  trial.warnings = warnings;
  trial.start_jacobian = start_jacobian;
endfunction

%!test
%! scene = check_mechanism (setfield (chain (2), "duration", 0.02));
%! trial = mechanism_trial (scene, mechanism_rungs (scene, [0 0]));
%! assert (size (trial.x), [22 2]); assert (size (trial.start_jacobian), [4 8]);
