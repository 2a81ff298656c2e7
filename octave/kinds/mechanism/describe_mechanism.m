## -*- texinfo -*-
## @deftypefn {} {@var{own} =} describe_mechanism (@var{scene}, @var{run})
## What the summary has of a mechanism's @var{run} alone: a struct of model (a sentence), bodies and joints (names),
## modes ([longitudinal, bending]) and stiffening of each body, and by what the constraints are off at most (m or rad,
## and a second).
## @end deftypefn

function own = describe_mechanism (scene, run)
  [models, history] = deal (run.model.models, run.history);
  own.model = strjoin ({how_many(numel (scene.bodies), "body", "bodies"), how_many(run.model.n, "coordinate"), ...
                        how_many(run.model.constraints.count, "constraint")}, ", ");
  own.bodies = {scene.bodies.name};
  own.joints = {scene.joints(:).name};
  own.modes = cellfun (@(model) [model.rung.longitudinal, model.rung.bending], models, "uniformoutput", false);
  own.stiffening = cellfun (@(model) model.rung.stiffening, models, "uniformoutput", false);
  own.largest_constraint_residual = max (history.residual);
  own.largest_constraint_velocity = max (history.velocity_residual);
endfunction

%!test
%! [system, ~, scene] = sample_mechanism ([1 2]);
%! run.model = system.mechanism;
%! run.history = struct ("residual", [1 3 2], "velocity_residual", [6 5 4]);
%! own = describe_mechanism (scene, run);
%! assert (own.model, "3 bodies, 18 coordinates, 5 constraints");
%! assert (own.bodies, {"body 1", "body 2", "body 3"}); assert (own.joints{6}, "joint 6");
%! assert (own.modes, {[1 2], [1 2], [1 2]}); assert (own.stiffening, repmat ({"foreshortening"}, 1, 3));
%! assert ([own.largest_constraint_residual, own.largest_constraint_velocity], [3 6]);
