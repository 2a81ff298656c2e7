## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} check_mechanism (@var{given})
## The scene of a mechanism with all its fields (see @code{mechanism_fields}): those @var{given}, checked, and defaults
## for the others; bodies and joints become struct arrays, a joint's bodies two numbers (0: the ground); longest is the
## length of the longest rod, before it is in pieces (see @code{in_pieces}).  The option
## "modes" of @code{driver} is for all bodies.
## @end deftypefn

function scene = check_mechanism (given)
  [fields, of_body] = mechanism_fields ();
  [scene, names] = as_bodies (spelled_start (without_probed (given)));
  scene = take_fields (same_modes (scene), fields, "a scene of bodies");
  refuse_missing_solver (scene.solver.name, "radau");
  scene.bodies = take_list (scene.bodies, of_body, names.bodies, "body", @check_body);
  if (isempty (scene.bodies))
    scene_error ("bodies is empty: it takes a struct for each body");
  endif
  scene.longest = max (arrayfun (@(body) body.rod.length, scene.bodies));
  scene.joints = check_joints (scene.joints, scene.bodies, names.joints);
  [scene.breaks, scene.probed] = load_breaks (joint_loads (scene.joints), scene.breaks, scene);
  scene.joints = with_values (scene.joints, scene.bodies);
  refuse_rates_of_joints (scene);
  scene.solver.tolerance = tolerance_in_metres (scene.solver.tolerance, mechanism_kind ().pixel (scene));
  scene = in_pieces (scene, scene.pieces);
endfunction

function scene = same_modes (scene)
  if (isfield (scene, "model") && isfield (scene.model, "modes") && isfield (scene, "bodies") ...
      && (iscell (scene.bodies) || isstruct (scene.bodies)))
    if (isstruct (scene.bodies))
      scene.bodies = num2cell (scene.bodies);
    endif
    for k = find (cellfun (@isstruct, scene.bodies(:).'))
      scene.bodies{k}.model.modes = scene.model.modes;
    endfor
    scene.model = rmfield (scene.model, "modes");
    if (isempty (fieldnames (scene.model)))
      scene = rmfield (scene, "model");
    endif
  endif
endfunction

function refuse_rates_of_joints (scene)
  for k = 1:numel (scene.joints)
    [numbers, orders] = value_size (scene.joints(k));
    for part = 1:numbers*(orders == 3)
      refuse_wrong_rates (@(t) scene.joints(k).value (t)(:,part), scene.duration, scene.joints(k).value_name, ...
                          {"value", "rate", "second rate", "a value"});
    endfor
  endfor
endfunction

function body = check_body (body, what)
  prefix = field_prefix (what);
  check_section (body.rod, prefix);
  if (! isempty (body.rod.curvature))
    check_curvature (body.rod, prefix);
    if (strcmp (body.model.stiffening, "foreshortening"))
      scene_error ("%srod.curvature is given: a curved rod takes no model.stiffening = \"foreshortening\"", prefix);
    endif
  endif
  if (strcmp (body.model.axial, "quasistatic"))
    scene_error ("%smodel.axial is \"quasistatic\": a rod of a mechanism takes \"dynamic\" or \"none\"", prefix);
  endif
endfunction

%!function scene = two ()
%!  scene.bodies = {struct("rod", struct ("length", 1, "EA", 1e6, "EI", 20, "rhoA", 1)), ...
%!                  struct("rod", struct ("length", 2, "width", 0.02, "half_height", 0.01))};
%!  scene.joints = {struct("kind", "revolute", "bodies", 1, "stations", 0), ...
%!                  struct("kind", "revolute", "bodies", [1 2], "stations", [1 0])};
%!  scene.duration = 1;
%!endfunction
%!test
%! scene = check_mechanism (two ());
%! assert (scene.joints(1).bodies, [1 0]); assert (scene.joints(2).stations, [1 0]);
%! assert (scene.bodies(2).name, "body 2");
%!error <joints\(1\).kind is "glue": it takes "revolute", "weld",>
%! scene = two (); scene.joints{1}.kind = "glue"; check_mechanism (scene);
%!error <joints\(2\).bodies is \[1  3\]: it takes a body's number from 1 to 2>
%! scene = two (); scene.joints{2}.bodies = [1 3]; check_mechanism (scene);
%!error <joints\(2\).stations\(1\) is 1.5: it takes a place on body 1, from 0 to 1 m>
%! scene = two (); scene.joints{2}.stations = [1.5 0]; check_mechanism (scene);
%!error <joints\(2\).rest is 1: a bushing holds its points together, its rest is 0>
%! scene = two (); [scene.joints{2}.kind, scene.joints{2}.rest] = deal ("bushing", 1); check_mechanism (scene);
%!error <bodies\(1\).rod.length is -1: it takes positive number in m>
%! scene = two (); scene.bodies{1}.rod.length = -1; check_mechanism (scene);
%!error <bodies\(2\).rod.width and>
%! scene = two (); scene.bodies{2}.rod.width = []; check_mechanism (scene);
%!error <joints\(3\).value gives \[1 NaN 0\] at t = 0: it takes 3 numbers, a row each for place, rate and acceleration>
%! scene = two (); scene.joints{3} = struct ("kind", "angle", "bodies", 1, "stations", 0, "value", @(t) [1 NaN 0]);
%! check_mechanism (scene);
%!error <joints\(2\).value gives rate = .*, where its value rises by .* a second: it takes a value and its rates>
%! scene = two ();
%! scene.joints{2} = struct ("kind", "position", "bodies", 2, "stations", 0, "value", @(t) [1 t^2; 0 t; 0 2]);
%! check_mechanism (scene);
