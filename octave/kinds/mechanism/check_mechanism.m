## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} check_mechanism (@var{given})
## The scene of a mechanism with all its fields (see @code{mechanism_fields}): those @var{given}, checked, and defaults
## for the others; bodies and joints become struct arrays, a joint's bodies two numbers (0: the ground).  The option
## "modes" of @code{driver} is for all bodies.
## @end deftypefn

function scene = check_mechanism (given)
  [fields, of_body, of_joint] = mechanism_fields ();
  scene = take_fields (same_modes (as_bodies (without_probed (given))), fields, "a scene of bodies");
  refuse_missing_solver (scene.solver.name, "radau");
  scene.bodies = checked_list (scene.bodies, of_body, "bodies", @check_body);
  scene.joints = checked_list (scene.joints, of_joint, "joints", @(joint, what) check_joint (joint, what, scene));
  [scene.breaks, scene.probed] = load_breaks (joint_loads (scene.joints), scene.breaks, scene);
  for k = 1:numel (scene.joints)
    scene.joints(k).value = joint_value (scene.joints(k), sprintf ("joints(%d).value", k), scene.bodies);
  endfor
  scene.solver.tolerance = tolerance_in_metres (scene.solver.tolerance, mechanism_kind ().pixel (scene));
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

function list = checked_list (given, fields, name, check)
  if (isstruct (given))
    given = num2cell (given);
  endif
  list = struct ([]);
  for k = 1:numel (given)
    what = sprintf ("%s(%d)", name, k);
    if (! (isstruct (given{k}) && isscalar (given{k})))
      scene_error ("%s is a %s: it takes a struct", what, class (given{k}));
    endif
    item = check (take_fields (given{k}, fields, what), what);
    if (isempty (item.name))
      item.name = sprintf ("%s %d", name(1:end-1), k);
      item.name = strrep (item.name, "bodie ", "body ");
    endif
    list = [list, item];
  endfor
  if (isempty (list))
    names = unique (strtok (fields(:,1), "."));
    list = cell2struct (cell (0, numel (names)), names, 2).';
  endif
endfunction

function body = check_body (body, what)
  check_section (body.rod, [what "."]);
  if (! isempty (body.rod.curvature))
    check_curvature (body.rod, [what "."]);
    if (body.tip_mass > 0 || strcmp (body.model.stiffening, "foreshortening"))
      scene_error ("%s.rod.curvature is given: a curved rod takes no tip_mass and no model.stiffening", what);
    endif
  endif
  if (strcmp (body.model.axial, "quasistatic"))
    scene_error ("%s.model.axial is \"quasistatic\": a rod of a mechanism takes \"dynamic\" or \"none\"", what);
  endif
endfunction

function joint = check_joint (joint, what, scene)
  bodies = joint.bodies(:).';
  if (! any (numel (bodies) == [1 2]) || any (bodies != fix (bodies)) || bodies(1) < 1 || any (bodies < 0) ...
      || any (bodies > numel (scene.bodies)) || (numel (bodies) == 2 && bodies(1) == bodies(2)))
    scene_error ("%s.bodies is [%s]: it takes a body's number from 1 to %d, and another's or 0 for the ground", ...
                 what, num2str (bodies), numel (scene.bodies));
  endif
  joint.bodies = [bodies, 0](1:2);
  on = joint.bodies(joint.bodies > 0);
  if (numel (joint.stations) != numel (on))
    scene_error ("%s.stations are [%s]: it takes a station on each of its %d bodies", what, ...
                 num2str (joint.stations(:).'), numel (on));
  endif
  for k = 1:numel (on)
    length = scene.bodies(on(k)).rod.length;
    if (joint.stations(k) < 0 || joint.stations(k) > length)
      scene_error ("%s.stations(%d) is %g: body %d has places from 0 to %g m", what, k, joint.stations(k), ...
                   on(k), length);
    endif
  endfor
  joint.stations = [joint.stations(:).', 0](1:2);
  if (numel (joint.point) != 2)
    scene_error ("%s.point has %d numbers: it takes [x y] in m", what, numel (joint.point));
  endif
  if (strcmp (joint.kind, "bushing") && joint.rest != 0)
    scene_error ("%s.rest is %g: a bushing holds its points together, its rest is 0", what, joint.rest);
  endif
  joint.constant = isnumeric (joint.value);
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
%!error <joints\(2\).stations\(1\) is 1.5: body 1 has places from 0 to 1 m>
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
