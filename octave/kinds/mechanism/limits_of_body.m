## -*- texinfo -*-
## @deftypefn {} {@var{limits} =} limits_of_body (@var{scene}, @var{run}, @var{k})
## What the model of the @var{k}th body of a mechanism's @var{run} holds for (see @code{rod_limits}), slopes up to 0.3.
## @end deftypefn

function limits = limits_of_body (scene, run, k)
  limits = rod_limits (scene.bodies(k), run.model.models{k}, run.history.bodies(k), 0.3);
endfunction

%!test
%! [system, start, scene] = sample_mechanism ([0 1]);
%! run = struct ("model", system.mechanism, "history", measure_mechanism (system, 0, start));
%! assert ([limits_of_body(scene, run, 2)(1:2).limit], [0.3 0.01]);
