## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} check_scene (@var{given})
## The scene with all its fields: those @var{given}, checked, and the defaults of @code{scene_fields} for the others.
##
## An unknown field, or a value of a wrong type, size or sign, or one that is not finite, is an error that names the
## field, what it got and what it takes.
## @end deftypefn

function scene = check_scene (given)
  if (! (isstruct (given) && isscalar (given)))
    scene_error ("a scene is a function that returns a struct, not a %s", class (given));
  endif
  scene = take_fields (spelled_start (without_probed (given)), scene_fields (), "a scene");
  refuse_missing_solver (scene.solver.name, "lsode_bdf");
  check_section (scene.rod);
  scene.joints = check_joints (on_one_body (scene.joints), scene);
  loads = [loads_of(scene), joint_loads(scene.joints)];
  scene = with_breaks (scene, loads);
  scene.joints = with_values (scene.joints, scene);
  if (isnumeric (scene.moment))
    moment = scene.moment;
    scene.moment = @(t) moment + zeros (size (t));
  endif
  scene.force_station = station_of_force (scene);
  if (! isempty (scene.rod.curvature))
    check_curved (scene);
  endif
  if (! isempty (scene.rotation))
    refuse_with_rotation (scene);
  endif
  if (! isempty (scene.joints) && strcmp (scene.model.axial, "quasistatic"))
    scene_error (["joints and model.axial = \"quasistatic\" are both given: a rod with joints takes \"dynamic\" or" ...
                  " \"none\""]);
  endif
  scene.solver.tolerance = tolerance_in_metres (scene.solver.tolerance, plane_pixel (scene, scene.rod.length));
endfunction

## the tangent at O is prescribed: a moment there would do nothing, and phi follows
function refuse_with_rotation (scene)
  refuse_wrong_rates (scene.rotation, scene.duration);
  if (any (scene.moment (load_times (scene))))
    scene_error ("moment and rotation are both given: a hub that prescribes the rotation takes any moment at O");
  elseif (scene.initial.phi != 0 || scene.initial.phi_dot != 0)
    scene_error ("initial.phi, initial.phi_dot and rotation are both given: the rotation prescribes the angle");
  endif
endfunction

function loads = loads_of (scene)
  loads = load_list ({
    "moment",   scene.moment,   1, "a vectorised function of t in N m",                                   [],    true
    "rotation", scene.rotation, 3, "3 numbers, theta, theta_dot and theta_ddot in rad, rad/s and rad/s^2", [1 2], false
    "force",    scene.force,    2, "2 numbers, F_x and F_y in N",                                          [],    false
  });
endfunction

%!function scene = smallest ()
%!  scene = struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.015), "duration", 1);
%!endfunction

%!test # defaults are filled in
%! scene = check_scene (smallest ());
%! assert (scene.gravity, 9.81);
%! assert (scene.rod.density, 7800);
%! assert (scene.moment (3), 0);
%!error <rod.length is missing: it takes positive number in m> check_scene (struct ("rod", struct ()))
%!error <rod.length is NaN: it takes positive number in m> check_scene (setfield (smallest (), "rod", "length", NaN))
%!error <colour is not a field of a scene: those are title, rod.length,>
%! check_scene (setfield (smallest (), "colour", 1));
%!error <rod.colour is not a field of a scene> check_scene (setfield (smallest (), "rod", "colour", 1))
%!error <rod is a double: it takes a struct> check_scene (setfield (smallest (), "rod", 3))
%!error <rod.width and rod.half_height are missing>
%! check_scene (struct ("rod", struct ("length", 1), "duration", 1))
%!error <rod.EA, rod.EI and rod.rhoA are given together> check_scene (setfield (smallest (), "rod", "EA", 1))
%!error <rotation gives 3 at t = 0: it takes 3 numbers, theta,>
%! check_scene (setfield (smallest (), "rotation", @(t) 3));
%!error <force fails at t = 0: no wind> check_scene (setfield (smallest (), "force", @(t) error ("no wind")))
%!error <force_station is 2: it takes a place on the rod, from 0 to 1 m>
%! check_scene (setfield (smallest (), "force_station", 2));
%!error <moment and rotation are both given>
%! check_scene (setfield (setfield (smallest (), "moment", 1), "rotation", @(t) [0 0 0]))
%!error <rotation prescribes the angle>
%! check_scene (setfield (setfield (smallest (), "initial", "phi", 1), "rotation", @(t) [0 0 0]))
%!error <moment gives 300 at t = \[0.*1\]: it takes a vectorised function>
%! check_scene (setfield (smallest (), "moment", @(t) 300))
%!error <moment fails at t = .*nonconformant> check_scene (setfield (smallest (), "moment", @(t) t*t))
%!error <a scene is a function that returns a struct, not a double> check_scene (3)
%!error <initial.V1 is "a": it takes vector of amplitudes in m>
%! check_scene (setfield (smallest (), "initial", "V1", "a"));
%!error <joints\(1\).kind is missing: it takes> driver (setfield (smallest (), "joints", {struct()}), "output", "")
%!error <joints\(1\).bodies is \[2\]: it takes a body's number from 1 to 1, and another's or 0 for the ground>
%! check_scene (setfield (smallest (), "joints", struct ("kind", "spring", "bodies", 2, "stations", 1)));
%!error <joints and model.axial = "quasistatic" are both given>
%! spring = struct ("kind", "torsion_spring", "stations", 0);
%! check_scene (setfield (setfield (smallest (), "model", "axial", "quasistatic"), "joints", spring));
%!error <joints\(1\).value gives NaN at t = 0: it takes 1 number>
%! check_scene (setfield (smallest (), "joints", struct ("kind", "moment", "stations", 1, "value", @(t) NaN)));
%!test # a force at the tip, a hub that turns, and a constant moment are scenes
%! assert (check_scene (setfield (smallest (), "force_station", 1)).force_station, 1);
%! scene = check_scene (setfield (smallest (), "rotation", @(t) [0 0 0]));
%! assert (scene.force_station, 1); assert (scene.solver.tolerance, plane_pixel (scene, 1)/2, plane_pixel (scene, 1));
%! assert (check_scene (setfield (smallest (), "moment", 3)).moment ([1 2]), [3 3]);
%!error <rotation prescribes the angle>
%! check_scene (setfield (setfield (smallest (), "initial", "phi_dot", 1), "rotation", @(t) [0 0 0]))
%!error <rotation jumps from 0 to 1 at t = 0.5, its number 1: no force can make a prescribed place or rate jump>
%! check_scene (setfield (smallest (), "rotation", @(t) [t > 0.5; 0; 0]));
%!error <rotation jumps from 1 to 2 at t = 0.5, its number 2>
%! check_scene (setfield (smallest (), "rotation", @(t) [t; 1 + (t > 0.5); 0]));
