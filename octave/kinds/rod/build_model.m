## -*- texinfo -*-
## @deftypefn {} {@var{model} =} build_model (@var{scene}, @var{rung})
## The model of a checked scene's rod on a rung of the ladder (see @code{rung_of_scene}): a projection V = basis*q of
## the same general arrays.  A rung that has its base functions and the basis, that of another run's end, keeps them.
##
## Fields are those of @code{rod_model}, with basis (N-by-n), arrays projected to it and with the scalars of the
## followers, and whole_mass_matrix and whole_coupling_vector (not projected), force (shape_1, shape_2,
## shortening_matrix where it acts), followers (longitudinal modes without inertia, or empty) and equations (see
## @code{matrix_equations}).
## @end deftypefn

function model = build_model (scene, rung)
  model = rod_model (scene, rung, base_of (rung, scene));
  model.equations = matrix_equations ();
  arrays = model.arrays;
  model.whole_mass_matrix = arrays.mass_matrix;
  model.whole_coupling_vector = arrays.coupling_vector;
  N1 = numel (model.base.longitudinal);
  if (isfield (rung, "basis"))
    model.basis = reshape (rung.basis, rows (arrays.mass_matrix), []);
  else
    stiffness = stiffness_of_joints (scene, model);
    model.basis = rung_basis (rung, arrays, model.base, ! isempty (scene.rotation), stiffness);
  endif
  model.arrays = project_arrays (arrays, model.basis);
  if (strcmp (rung.axial, "quasistatic"))
    model.followers = followers_of (arrays, 1:N1, functions_at (model.base, scene.force_station));
  endif
  model.arrays = set_followers (model.arrays, model.followers);

  [along, across] = functions_at (model.base, scene.force_station);
  [force.shape_1, force.shape_2] = deal (along.', across.');
  force.shortening_matrix = model.shortening*shortening_at (model.base, scene.force_station);
  model.force = project_arrays (force, model.basis);
endfunction

function base = base_of (rung, scene)
  if (isfield (rung, "base"))
    base = base_functions (rung.base.longitudinal, rung.base.transversal, scene.rod.length);
    return;
  elseif (! isempty (rung.sines))
    base = base_functions (1:rung.sines(1), 1:rung.sines(2), scene.rod.length);
    return;
  endif
  sines = 1:30;
  along = across = [];
  [pushed, turned] = stations_of_joints (scene.joints, 1);
  if (! strcmp (rung.axial, "none"))
    pushed = [pushed, scene.force_station(! isempty (scene.force)), scene.rod.length(scene.tip_mass > 0)];
    along = [sines, elongation_numbers(pushed, scene.rod, rod_section (scene.rod, scene.model))];
  endif
  if (rung.bending > 0)
    at_O = zeros (1, ! isempty (scene.rotation) || any (scene.moment (load_times (scene))));
    across = [sines, moment_corrections([turned, at_O], scene.rod.length)];
  endif
  base = base_functions (along, across, scene.rod.length);
endfunction

## of the base functions, (N+1)-by-(N+1); empty without joints, or where they are taken as they are
function K = stiffness_of_joints (scene, model)
  K = [];
  if (! isempty (scene.joints) && isempty (model.rung.sines))
    joined = joined_rod (model, scene.joints);
    q = zeros (rows (model.basis), 1);
    phi = first_angle (scene);
    refuse_coincident (scene.joints, joined, marker_places (joined, [q; phi; 0; 0]));
    K = tangent_of_joints (0, q, phi, joined);
  endif
endfunction

function phi = first_angle (scene)
  phi = scene.initial.phi;
  if (! isempty (scene.rotation))
    phi = scene.rotation (0)(1);
  endif
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
%!test # a joint's force has its elongation also beside a force of the scene's own
%! scene = setfield (swing (), "force", @(t) [1 0]);
%! scene.force_station = 0.5*scene.rod.length;
%! scene.model.energy = "uniaxial";
%! scene.joints = {struct("name", "pull", "kind", "force", "stations", 0.2*scene.rod.length, "value", [1 0])};
%! scene = check_scene (scene);
%! rung = struct ("sines", [], "bending", 1, "longitudinal", 1, "axial", "dynamic", "stiffening", "none");
%! assert (build_model (scene, rung).base.longitudinal, [1:30, -0.5, -0.2], 1e-12);
%!error <joint 1: the points of the spring coincide at the start> # where the modes come from it, too
%! scene = setfield (swing (), "joints", struct ("kind", "spring", "stations", 0.5, "point", [0.5 0], "stiffness", 10));
%! scene.initial.phi = 0;
%! driver (scene, "output", "");
