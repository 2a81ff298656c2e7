## -*- texinfo -*-
## @deftypefn {} {@var{constants} =} rod_constants (@var{scene}, @var{model})
## What the rates and forces of a rod need besides its state: a struct of inverse_mass_matrix and mass_matrix, the
## loads moment (t) and force (t), pulls_followers (whether longitudinal modes without inertia follow the force; see
## @code{force_at}), interval ([start, end], s, without a jump of the loads: all times) and lists of arguments of the generated functions: arguments (from the mass matrix
## to the damping, in the order of @code{rod_equations}), energy_arguments, stiffness_arguments, slopes (where the
## moment works) and force_arguments.
## @end deftypefn

function constants = rod_constants (scene, model)
  a = model.arrays;
  constants.mass_matrix = a.mass_matrix;
  constants.inverse_mass_matrix = inv (a.mass_matrix);
  constants.energy_arguments = {
    a.mass_matrix, a.gyroscopic_matrix, a.coupling_vector, a.centrifugal_vector, a.centrifugal_matrix, ...
    a.moment_of_inertia, a.stiffness_matrix, scene.gravity, a.static_moment, a.first_moment_1, a.first_moment_2, ...
    a.shortened_moment_matrix, a.follower_dd, a.follower_ds, a.follower_ss};
  constants.arguments = [constants.energy_arguments, {scene.rod.damping}];
  constants.stiffness_arguments = {a.centrifugal_matrix, a.stiffness_matrix, scene.gravity, a.static_moment, ...
                                   a.first_moment_1, a.first_moment_2, a.shortened_moment_matrix};
  constants.slopes = {a.slope_1, a.slope_2};
  if (strcmp (scene.model.moment_work, "chord"))
    constants.slopes = {zeros(size (a.slope_1)), zeros(size (a.slope_1))};
  endif
  constants.moment = watched_load ("moment", scene.moment);
  constants.force = watched_load ("force", scene.force);
  constants.pulls_followers = ! isempty (scene.force) && ! isempty (model.followers);
  constants.interval = [0, scene.duration];
  constants.force_arguments = {scene.force_station, model.force.shape_1, model.force.shape_2, ...
                               model.force.shortening_matrix, a.follower_fd, a.follower_fs, a.follower_ff};
endfunction

%!test
%! [scene, model] = sample_rod ([1 2], "model.moment_work", "chord");
%! constants = rod_constants (scene, model);
%! assert (constants.slopes, {zeros(3, 1), zeros(3, 1)});
%! assert (constants.inverse_mass_matrix*constants.mass_matrix, eye (3), 1e-12);
