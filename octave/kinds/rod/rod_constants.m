## -*- texinfo -*-
## @deftypefn {} {@var{constants} =} rod_constants (@var{scene}, @var{model})
## What the rates and forces of a rod need besides its state: a struct of the loads moment (t) and force (t), of the
## hub's rotation (t) ([] without one),
## pulls_followers (whether longitudinal modes without inertia follow the force; see @code{force_at}), ends (s, of
## the intervals in which no load jumps) and what the generated functions take: rod (the @var{model}'s arrays,
## inverse_mass_matrix, damping and the slopes where the moment works), gravity, point (of the force) and joined (of
## its joints: see @code{joined_rod}).
## @end deftypefn

function constants = rod_constants (scene, model)
  a = model.arrays;
  constants.rod = a;
  constants.rod.inverse_mass_matrix = inv (a.mass_matrix);
  constants.rod.damping = scene.rod.damping;
  constants.rotation = watched_columns ("rotation", scene.rotation);
  if (isempty (scene.rotation) && strcmp (scene.model.moment_work, "chord"))  # a hub holds the tangent
    constants.rod.slope_1 = constants.rod.slope_2 = zeros (size (a.slope_1));
  endif
  constants.gravity = scene.gravity;
  constants.moment = watched_load ("moment", scene.moment);
  constants.force = watched_columns ("force", scene.force);
  constants.pulls_followers = ! isempty (scene.force) && ! isempty (model.followers);
  [~, constants.ends] = meet_breaks ([0, scene.duration], scene.breaks);
  constants.point = model.force;
  constants.point.station = scene.force_station;
  constants.joined = joined_rod (model, scene.joints);
  for name = {"follower_fd", "follower_fs", "follower_ff"}
    constants.point.(name{1}) = a.(name{1});
  endfor
endfunction

%!test
%! [scene, model] = sample_rod ([1 2], "model.moment_work", "chord");
%! constants = rod_constants (scene, model);
%! assert ([constants.rod.slope_1, constants.rod.slope_2], zeros (3, 2));
%! assert (constants.rod.inverse_mass_matrix*constants.rod.mass_matrix, eye (3), 1e-12);
%!test # what the rates need of loads, of followers that a force pulls, and of the force's point
%! scene = setfield (damped (), "force", @(t) [3 5]);
%! scene.force_station = 0.25;
%! scene = check_scene (scene);
%! rung = struct ("sines", [], "bending", 1, "longitudinal", 0, "axial", "quasistatic", "stiffening", ...
%!   "foreshortening");
%! model = build_model (scene, rung);
%! constants = rod_constants (scene, model);
%! assert (constants.ends, [0, scene.breaks, scene.duration]); assert (constants.gravity, scene.gravity);
%! assert (constants.rod.damping, scene.rod.damping); assert (constants.rod.damping > 0);
%! assert (constants.pulls_followers); assert (constants.force (1), [3; 5]);
%! assert (constants.moment (0.1), scene.moment (0.1)); assert (constants.point.station, 0.25);
%! for name = {"follower_fd", "follower_fs", "follower_ff"}
%!   assert (constants.point.(name{1}), model.arrays.(name{1}));
%! endfor
%! assert (model.arrays.follower_ff > 0);
%! assert (! rod_constants (setfield (scene, "force", []), model).pulls_followers);
