## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} dampers_couple (@var{given})
## Whether dampers among the joints of a @var{given} scene of one straight rod couple its modes, of five sines and the
## rotation, faster than any of them oscillates.  Methods that take the modes' oscillation exactly, each for itself,
## crawl then.  Of a scene with a mistake, which its check will tell, it is false.
## @end deftypefn

function yes = dampers_couple (given)
  yes = false;
  try
    scene = take_fields (without_probed (given), scene_fields (), "a scene");
    scene.joints = check_joints (on_one_body (scene.joints), scene);
    if (any ([scene.joints.damping] > 0))
      yes = coupling (scene) > 1;
    endif
  catch err
    rethrow_others (err, "toolchain:scene");
  end_try_catch
endfunction

## the largest rate of coupling over the largest frequency
function ratio = coupling (scene)
  check_section (scene.rod);
  scene.model.modes = [0 5];
  scene.model.axial = "auto";
  scene.force_station = 0;
  model = build_model (scene, rung_of_scene (scene));
  a = model.arrays;
  is_damper = [scene.joints.damping] > 0;
  joints = with_values (scene.joints(is_damper), scene);
  c = struct ("rod", struct ("stiffness_matrix", a.stiffness_matrix, "damping", 0), ...
              "joined", joined_rod (model, joints));
  phi = scene.initial.phi;
  if (! isempty (scene.rotation))
    phi = scene.rotation (0)(1);
  endif
  [stiffness, damping] = linear_rod (phi, c);
  [X, squares] = free_modes (stiffness, mass_with_rotation (a));
  between = X.'*damping*X;
  between -= diag (diag (between));
  ratio = norm (between)/sqrt (max (squares));
endfunction

%!function scene = damped (kind, station, stiffness, damping)
%!  scene.rod = struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1);
%!  [scene.gravity, scene.duration, scene.frames_per_second] = deal (1, 0.1, 20);
%!  scene.model = struct ("modes", [0 5], "energy", "uniaxial");
%!  scene.joints = struct ("kind", kind, "stations", station, "point", [station 1], "stiffness", stiffness, ...
%!                         "damping", damping);
%!endfunction
%!test # such a rod is a mechanism
%! for row = {"torsion_spring", 0, 1, 0.1; "torsion_spring", 0, 1, 0; "spring", 0.5, 1e6, 1e3}.'
%!   assert (kind_of (damped (row{:})).name, "rod");
%! endfor
%! for row = {"torsion_spring", 0, 1, 1; "spring", 0.5, 1e6, 1e6}.'
%!   assert (kind_of (damped (row{:})).name, "mechanism");
%! endfor
%!assert (! dampers_couple (struct ("joints", {{3}})))
