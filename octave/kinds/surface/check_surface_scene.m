## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} check_surface_scene (@var{given})
## The scene of a rod on a surface with all its fields: those @var{given}, checked, and the defaults of
## @code{surface_scene_fields}.  Loads come back as functions of t.
## @end deftypefn

function scene = check_surface_scene (given)
  given = spelled_start (without_probed (given));
  if (! (isstruct (given.surface) && isscalar (given.surface)))
    scene_error ("surface is a %s: it takes a struct with a name and its parameters", class (given.surface));
  endif
  fields = [{"surface", NaN, "struct array"}; surface_scene_fields()];
  scene = take_fields (given, fields, "a scene on a surface");
  refuse_missing_solver (scene.solver.name, "lsode_bdf");
  scene.rod = section_on_surface (scene.rod, scene.model.strain);
  if (! isempty (scene.rod.curvature))
    check_curvature (setfield (scene.rod, "curvature_breaks", []), "");
  endif
  scene.force_station = station_of_force (scene);
  if (! isfield (scene.surface, "side"))
    scene.surface.side = 1;
  elseif (! any (isequal (scene.surface.side, 1) || isequal (scene.surface.side, -1) || ...
                 isequal (scene.surface.side, 0)))
    scene_error ("surface.side is not 1, -1 or 0: the side of the normal, the other, or both");
  endif
  surface_functions (scene.surface);  # its name and its parameters are known
  scene.solver.tolerance = tolerance_in_metres (scene.solver.tolerance, surface_kind ().pixel (scene));
  if (ischar (scene.model.modes) && any (scene.model.sines))
    scene_error ("model.sines are beside so many polynomials as model.modes says: give it, [4 4] say, not \"auto\"");
  endif
  loads = load_list ({
    "moment",     scene.moment,     1, "a number in N m",                  [], false
    "tip_moment", scene.tip_moment, 1, "a number in N m",                  [], false
    "force",      scene.force,      3, "3 numbers, F_x, F_y and F_z in N", [], false
    "rotation",   scene.rotation,   3, "3 numbers, theta, theta_dot and theta_ddot in rad, rad/s, rad/s^2", [1 2], false
    "place",      scene.place,      6, "6 numbers, a row each for coordinates and their two rates", [1 2 4 5], false
  });
  refuse_chart_motion (scene);
  [scene.joints, of_joints] = joints_on_surface (scene);
  scene = with_breaks (scene, [loads, of_joints]);
  if (! isempty (scene.rotation))
    refuse_wrong_rates (scene.rotation, scene.duration);
    refuse_moving (scene, "rotation", 2:3);
  endif
  if (! isempty (scene.place))
    for k = 1:2
      refuse_wrong_rates (@(t) scene.place (t)(:,k), scene.duration, "place", ...
                          {"coordinate", "rate", "second rate", "a coordinate"});
    endfor
    refuse_moving (scene, "place", [2 3 5 6]);
  endif
endfunction

function refuse_moving (scene, name, rates)
  if (strcmp (scene.initial.from, "equilibrium") && any (scene.(name) (0)(rates)))
    scene_error (["initial is \"equilibrium\" and the %s has a rate or an acceleration at t = 0: it" ...
                 " takes one that begins from rest"], name);
  endif
endfunction

%!function scene = smallest ()
%!  scene = struct ("surface", struct ("name", "sphere", "radius", 1), "duration", 1, ...
%!                  "rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1));
%!endfunction

%!test # defaults are filled in
%! scene = check_surface_scene (smallest ());
%! assert (scene.solver.tolerance, 1/1440);
%! assert (scene.surface.side, 1); assert (scene.rod.half_height, 1/200);
%! assert (scene.rod.EI_normal, 1); assert (scene.gravity, 9.81); assert (scene.force, [0 0 0]);
%!error <surface is a char: it takes a struct> check_surface_scene (setfield (smallest (), "surface", "bowl"))
%!error <rod.EA is -1: it takes positive number in N> check_surface_scene (setfield (smallest (), "rod", "EA", -1))
%!error <rod.EA, rod.EI and rod.rhoA are given together>
%! check_surface_scene (setfield (smallest (), "rod", struct ("length", 1, "EA", 1)))
%!error <ends is a 1-by-1 cell: it takes two of "free", "hinge" and "clamped">
%! check_surface_scene (on_level_plane ("ends", {{"free"}}))
%!error <ends is a 1-by-2 cell: it takes> check_surface_scene (on_level_plane ("ends", {{"free", "loose"}}))
%!error <model.modes is 2   2: it takes "auto" or two numbers of polynomials \[N1 N2\], at least 3 each>
%! check_surface_scene (setfield (on_level_plane (), "model", "modes", [2 2]))
%!error <force is 1   2: it takes three numbers or function of t in N>
%! check_surface_scene (on_level_plane ("force", [1 2]))
%!error <initial.point is 1   2   3: it takes vector of two coordinates>
%! check_surface_scene (setfield (on_level_plane (), "initial", "point", [1 2 3]))
%!error <colour is not a field of a scene on a surface> check_surface_scene (setfield (smallest (), "colour", 1))
%!error <force gives 3 at t = 0: it takes 3 numbers> check_surface_scene (setfield (smallest (), "force", @(t) 3))
%!error <tip_moment fails at t = 0: no> check_surface_scene (setfield (smallest (), "tip_moment", @(t) error ("no")))
%!error <surface.side is not 1, -1 or 0> check_surface_scene (setfield (smallest (), "surface", "side", 2))
%!error <model.sines are beside so many polynomials as model.modes says>
%! check_surface_scene (setfield (smallest (), "model", "sines", [2 2]))
%!error <surface.name is "egg": it takes one of> check_surface_scene (setfield (smallest (), "surface", "name", "egg"))
%!error <surface.radius is "x": it takes> check_surface_scene (setfield (smallest (), "surface", "radius", "x"))
%!test # any side, and what it states of its own
%! for side = [-1 0 1]
%!   assert (check_surface_scene (setfield (smallest (), "surface", "side", side)).surface.side, side);
%! endfor
%! scene = setfield (setfield (smallest (), "rod", "EI_normal", 7), "rod", "half_height", 0.02);
%! scene.force = [1 2 3]; scene.initial.point = [0.1 0.2]; scene.model.modes = [3 4];
%! checked = check_surface_scene (scene);
%! assert ({checked.rod.EI_normal, checked.rod.half_height, checked.force}, {7, 0.02, [1 2 3]});
%! assert ({checked.initial.point, checked.initial.angle, checked.model.modes}, {[0.1 0.2], 0, [3 4]});
%!error <rod.colour is not a field of a scene on a surface>
%! check_surface_scene (setfield (smallest (), "rod", "colour", 1))
%!error <rod is a double: it takes a struct> check_surface_scene (setfield (smallest (), "rod", 1))
%!test # what is empty by default is as if it were not given
%! assert (check_surface_scene (setfield (smallest (), "rod", "half_height", [])).rod.half_height, 1/200);
%!error <^rods is not a field of a scene on a surface>
%! check_surface_scene (setfield (smallest (), "rods", struct ("GJ", 1)))
%!error <rotation gives theta_dot = .*: it takes an angle and its rates>
%! scene = setfield (setfield (smallest (), "ends", {"clamped", "free"}), "rotation", @(t) [t^2 t 2]);
%! check_surface_scene (scene);
%!error <rotation gives 3 at t = 0: it takes 3 numbers>
%! scene = setfield (setfield (smallest (), "ends", {"clamped", "free"}), "rotation", @(t) 3);
%! check_surface_scene (setfield (scene, "initial", "equilibrium"));
%!error <place and the surface "sphere" are both given>
%! check_surface_scene (setfield (smallest (), "place", @(t) zeros (3, 2)));
%!error <place is given and no end is held>
%! scene = setfield (smallest (), "surface", struct ("name", "cylinder", "radius", 1));
%! check_surface_scene (setfield (scene, "place", @(t) zeros (3, 2)));
%!error <place jumps from 0 to 1 at t = 0.5, its number 1: no force can make a prescribed place>
%! scene = on_level_plane ("place", @(t) [t>=0.5, 0; 0 0; 0 0]);
%! check_surface_scene (scene);
%!error <place gives rate = 0 at t = .*, where its coordinate rises by 1 a second: it takes a coordinate and its rates>
%! check_surface_scene (on_level_plane ("place", @(t) [0 t; 0 0; 0 0]));
%!error <the place has a rate or an acceleration at t = 0>
%! check_surface_scene (on_level_plane ("place", @(t) [t 0; 1 0; 0 0], "initial", "equilibrium"));
%!error <the rotation has a rate or an acceleration at t = 0>
%! scene = setfield (setfield (smallest (), "ends", {"clamped", "free"}), "rotation", @(t) [t 1 0]);
%! check_surface_scene (setfield (scene, "initial", "equilibrium"));
%!error <surface is no struct with a name>
%! check_surface_scene (setfield (setfield (smallest (), "rotation", @(t) [0 0 0]), "surface", struct ("radius", 1)));
