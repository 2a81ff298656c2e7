## -*- texinfo -*-
## @deftypefn {} {@var{model} =} build_model (@var{scene}, @var{rung})
## The model of a checked scene's rod on a rung of the ladder (see @code{rung_of_scene}): a projection V = basis*q of
## the same general arrays.
##
## Fields: rung, section, base (@code{base_functions}), basis (N-by-n), arrays (@code{rod_arrays}, projected, with
## slope_1, slope_2 of (27) and the scalars of the followers), whole_mass_matrix and whole_coupling_vector (not
## projected; a curved rod has the same fields, from @code{build_curved_model}), force (shape_1, shape_2,
## shortening_matrix where it acts), followers (longitudinal modes without inertia, or empty) and shortening (1 or 0).
## @end deftypefn

function model = build_model (scene, rung)
  if (! isempty (scene.rod.curvature))
    model = build_curved_model (scene, rung);
    return;
  endif
  model.rung = rung;
  model.length = scene.rod.length;
  model.section = rod_section (scene.rod, scene.model);
  model.shortening = double (strcmp (rung.stiffening, "foreshortening"));
  model.base = base_of (rung, scene, model.section);

  arrays = rod_arrays (model.base, model.section, model.shortening);
  if (scene.tip_mass > 0)
    arrays = add_point_mass (arrays, model.base, model.length, scene.tip_mass, model.shortening);
  endif
  [arrays.slope_1, arrays.slope_2] = slopes_at (model.base, 0, model.shortening);
  model.whole_mass_matrix = arrays.mass_matrix;
  model.whole_coupling_vector = arrays.coupling_vector;

  N1 = numel (model.base.longitudinal);
  model.basis = rung_basis (rung, arrays, model.base, ! isempty (scene.rotation), stiffness_of_joints (scene, model));
  model.arrays = project_arrays (arrays, model.basis);
  model.followers = [];
  if (strcmp (rung.axial, "quasistatic"))
    model.followers = followers_of (arrays, 1:N1, functions_at (model.base, scene.force_station));
  endif
  model.arrays = set_followers (model.arrays, model.followers);

  [force.shape_1, force.shape_2] = columns_at (model.base, scene.force_station, 0);
  force.shortening_matrix = model.shortening*shortening_at (model.base, scene.force_station);
  model.force = project_arrays (force, model.basis);
endfunction

function [along, across] = columns_at (base, station, derivative)
  [along, across] = functions_at (base, station, derivative);
  along = along.';
  across = across.';
endfunction

function base = base_of (rung, scene, section)
  if (! isempty (rung.sines))
    base = base_functions (1:rung.sines(1), 1:rung.sines(2), scene.rod.length);
    return;
  endif
  sines = 1:30;
  along = across = [];
  if (! strcmp (rung.axial, "none"))
    along = [sines, elongation_numbers(forced_stations (scene), scene.rod, section)];
  endif
  if (rung.bending > 0)
    across = sines;
  endif
  if (rung.bending > 0)
    across = [across, moment_corrections(scene)];
  endif
  base = base_functions (along, across, scene.rod.length);
endfunction

## of the base functions, (N+1)-by-(N+1); empty without joints, or where they are taken as they are
function K = stiffness_of_joints (scene, model)
  K = [];
  if (! isempty (scene.joints) && isempty (model.rung.sines))
    N = rows (model.whole_mass_matrix);
    joined = joined_rod (setfield (model, "basis", eye (N)), scene.joints);
    K = tangent_of_joints (0, zeros (N, 1), first_angle (scene), joined);
  endif
endfunction

function phi = first_angle (scene)
  phi = scene.initial.phi;
  if (! isempty (scene.rotation))
    phi = scene.rotation (0)(1);
  endif
endfunction

## where forces act along the rod
function stations = forced_stations (scene)
  stations = [];
  for joint = scene.joints(:).'
    if (! any (strcmp (joint.kind, {"torsion_spring", "moment"})))
      stations(end+1) = joint.stations(1);
    endif
  endfor
  if (! isempty (scene.force))
    stations = scene.force_station;
  endif
  if (scene.tip_mass > 0)
    stations(end+1) = scene.rod.length;
  endif
endfunction

## -1: a moment acts at O, -2: at the tip
function numbers = moment_corrections (scene)
  turned = [];
  for joint = scene.joints(:).'
    if (any (strcmp (joint.kind, {"torsion_spring", "moment"})))
      turned(end+1) = joint.stations(1);
    endif
  endfor
  at_O = ! isempty (scene.rotation) || any (scene.moment (load_times (scene))) || any (turned == 0);
  numbers = [-1 -2]([at_O, any(turned == scene.rod.length)]);
endfunction

function followers = followers_of (arrays, k, along)
  followers.flexibility = inv (arrays.stiffness_matrix(k,k));
  followers.centrifugal_vector = arrays.centrifugal_vector(k);
  followers.first_moment_1 = arrays.first_moment_1(k);
  followers.shape_1 = along(k).';
endfunction

## the scalars that the equations have of them, 0 without
function arrays = set_followers (arrays, followers)
  F = d = s = e = 0;
  if (! isempty (followers))
    F = followers.flexibility;
    d = followers.centrifugal_vector;
    s = followers.first_moment_1;
    e = followers.shape_1;
  endif
  arrays.follower_dd = d.'*F*d;
  arrays.follower_ds = d.'*F*s;
  arrays.follower_ss = s.'*F*s;
  arrays.follower_fd = e.'*F*d;
  arrays.follower_fs = e.'*F*s;
  arrays.follower_ff = e.'*F*e;
endfunction

%!test # the paper's sines are a basis of their own
%! [~, model] = sample_rod ([7 7]);
%! assert (model.basis, eye (14));
%! assert (numel (model.arrays.slope_1), 14);

%!test # static followers: the elongation of a rod in steady rotation
%! scene = check_scene (spin_up ());
%! rung = struct ("sines", [], "bending", 0, "longitudinal", 0, "axial", "quasistatic", "stiffening", "none");
%! model = build_model (scene, rung);
%! V1 = rod_followers (struct ("phi", 0, "phi_dot", 6), model.followers, 0, struct ("force_x", 0, "force_y", 0));
%! [along, across] = functions_at (model.base, 10);
%! assert (along*V1, 1.2*6^2*10^3/(3*2.8e7), 2e-5*5.14e-4);
