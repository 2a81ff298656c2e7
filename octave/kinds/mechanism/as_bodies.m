## -*- texinfo -*-
## @deftypefn {} {[@var{scene}, @var{names}] =} as_bodies (@var{given})
## A scene of one rod with @code{joints} that constrain it (a slider, say) as a scene of one body: its hinge at O, or,
## with a rotation, the hub that turns its tangent there, its moment and its force are joints of it, beside those
## given, which are on it where they do not say on which body.  Scenes that have bodies, or no rod, come back as they
## are.
##
## @var{names}: bodies and joints, what messages call them (see @code{take_list}), as they stand in @var{given}.
## @end deftypefn

function [scene, names] = as_bodies (given)
  scene = given;
  names = struct ("bodies", "bodies", "joints", "joints");
  if (isfield (given, "bodies") || ! isfield (given, "rod"))
    return;
  endif
  own = {"rod", "tip_mass", "initial", "model"};
  for name = intersect (own, fieldnames (given)).'
    body.(name{1}) = given.(name{1});
  endfor
  body = without_moment_work (body);
  short = short_fields (given);
  scene = rmfield (given, intersect ([own, fieldnames(short).'], fieldnames (given)));
  if (isfield (body, "initial") && isstruct (body.initial) && isfield (body.initial, "from"))
    scene.initial.from = body.initial.from;
    body.initial = rmfield (body.initial, "from");
  endif
  if (! isempty (short.rotation))
    body = turned_at_first (body, short.rotation (0));
  endif
  hinge = struct ("name", "hinge", "kind", "revolute", "bodies", 1, "stations", 0);
  own_joints = on_one_body (short.joints);
  scene.bodies = {body};
  scene.joints = [{hinge}, loads_of(short, isfield (given, "moment"), given.rod)];
  names.bodies = {"a scene"};
  names.joints = [cellfun(@(joint) joint.name, scene.joints, "uniformoutput", false), ...
                  arrayfun(@(k) sprintf ("joints(%d)", k), 1:numel (own_joints), "uniformoutput", false)];
  scene.joints = [scene.joints, own_joints];
  scene.breaks = [short.breaks(:); short.moment_breaks(:)];
endfunction

## what a scene of one rod says of its loads and joints, checked, and the defaults
function short = short_fields (given)
  names = {"rotation", "moment", "moment_breaks", "breaks", "force", "force_station", "joints"};
  fields = scene_fields ();
  fields{strcmp (fields(:,1), "force"),3} = "vector or function of t in N";  # as of any joint
  given = rmfield (given, setdiff (fieldnames (given), names));
  short = take_fields (given, fields(ismember (fields(:,1), names),:), "a scene");
endfunction

## a body knows no other than that by its tangent
function body = without_moment_work (body)
  if (isfield (body, "model") && isfield (body.model, "moment_work"))
    got = value_error ("\"tangent\"", body.model.moment_work);
    if (! isempty (got))
      scene_error ("model.moment_work is %s: the rod is a body of a mechanism here, which takes \"tangent\"", got);
    endif
    body.model = rmfield (body.model, "moment_work");
  endif
endfunction

## where the hub has it, unless it says otherwise
function body = turned_at_first (body, turn)
  names = {"phi", "phi_dot"};
  for k = find (numel (turn) == 3 & ! isfield (field_or (body, "initial", struct ()), names))
    body.initial.(names{k}) = turn(k);
  endfor
endfunction

function joints = loads_of (short, pushed, rod)
  joints = {};
  if (! isempty (short.rotation))
    joints{end+1} = struct ("name", "rotation", "kind", "angle", "bodies", 1, "stations", 0, "value", short.rotation);
  endif
  if (pushed)
    joints{end+1} = struct ("name", "moment", "kind", "moment", "bodies", 1, "stations", 0, "value", short.moment);
  endif
  if (! isempty (short.force))
    station = [];  # the tip, where the rod has a length
    if (isfield (rod, "length") && isnumeric (rod.length))
      station = rod.length;
    endif
    if (! isempty (short.force_station))
      station = station_on_rod ("force_station", short.force_station, station);
    endif
    joints{end+1} = struct ("name", "force", "kind", "force", "bodies", 1, "stations", station, "value", short.force);
  endif
endfunction

%!function scene = hinged ()
%!  scene.rod = struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1, "half_height", 0.005);
%!  scene.model = struct ("modes", [0 2], "energy", "uniaxial", "rotary_inertia", false, "stiffening", "none");
%!  [scene.gravity, scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0, 0.2, 20, 1e-7);
%!  scene.initial.phi_dot = 0.1;
%!endfunction
%!function message = refusal (scene)
%!  message = "";
%!  try
%!    check_mechanism (scene);
%!  catch err
%!    message = err.message;
%!  end_try_catch
%!endfunction
%!test # a spring at the hinge and a straight guide of the middle, in the short form and as a body
%! joints = {struct("kind", "torsion_spring", "stations", 0, "stiffness", 1), ...
%!           struct("kind", "slider", "stations", 0.5)};
%! short = setfield (setfield (hinged (), "joints", joints), "initial", struct ());
%! short.moment = @(t) sin (30*t);
%! long = struct ("gravity", 0, "duration", 0.2, "frames_per_second", 20, "solver", hinged ().solver);
%! long.bodies = {struct("rod", hinged ().rod, "model", hinged ().model)};
%! long.joints = [{struct("kind", "revolute", "bodies", 1, "stations", 0)}, ...
%!                cellfun(@(joint) setfield (joint, "bodies", 1), joints, "uniformoutput", false), ...
%!                {struct("kind", "moment", "bodies", 1, "stations", 0, "value", short.moment)}];
%! assert (kind_of (short).name, "mechanism");
%! tip = @(scene) driver (scene, "output", "").history.bodies.tip_y;
%! assert (tip (short), tip (long), 1e-12);
%! assert (max (abs (tip (short))) > 1e-3);
%!test # without a spring that bears anything it is the rod itself, with its moment, force and tip mass
%! scene = setfield (setfield (hinged (), "moment", @(t) 0.1*(t < 0.1)), "moment_breaks", 0.1);
%! scene = setfield (setfield (scene, "force", @(t) [0 -0.05]), "tip_mass", 0.5);
%! with = as_bodies (setfield (scene, "joints", {struct("kind", "torsion_spring", "stations", 0, "stiffness", 0)}));
%! assert (driver (with, "output", "").history.bodies.tip_y, driver (scene, "output", "").history.tip_y, 1e-6);
%!test # messages call everything as the scene has it
%! slider = struct ("kind", "slider", "stations", 0.5);
%! scene = setfield (setfield (hinged (), "moment", 0.1), "joints", {slider, slider});
%! refused = @(scene, message) assert (strncmp (refusal (scene), message, numel (message)));
%! refused (setfield (scene, "joints", 3), "joints is 3: it takes");
%! refused (setfield (scene, "joints", {slider, 3}), "joints(2) is a double");
%! refused (setfield (scene, "joints", {slider, setfield(slider, "stations", 2)}), "joints(2).stations(1) is 2: it");
%! refused (setfield (scene, "moment", @(t) [1 2]), "moment gives [1 2] at t = 0: it takes 1 number");
%! refused (setfield (scene, "moment", "much"), "moment is \"much\": it takes number or function of t in N m");
%! refused (setfield (scene, "rod", "length", -1), "rod.length is -1: it takes positive number in m");
%! refused (setfield (scene, "rod", "EA", []), "rod.EA, rod.EI and rod.rhoA are given together");
%! refused (setfield (scene, "rods", 3), "rods is not a field of");
%! refused (setfield (scene, "model", "moment_work", "chord"), "model.moment_work is \"chord\": ");
%! refused (setfield (scene, "model", "axial", "quasistatic"), "model.axial is \"quasistatic\": ");
%! refused (setfield (scene, "force", "much"), "force is \"much\": it takes vector or function of t in N");
%! assert (check_mechanism (setfield (scene, "force", [0 1])).joints(3).value (2), [0 1]);
%! [scene.force, scene.force_station] = deal (@(t) [0 1], 2);
%! refused (scene, "force_station is 2: it takes a place on the rod, from 0 to 1 m");
%! stated = setfield (setfield (hinged (), "joints", {slider}), "model", "moment_work", "tangent");
%! assert ({check_mechanism(stated).joints.name}, {"hinge", "joint 1"});
%!error <bodies is missing: it takes struct array> driver (struct ("joints", {{}}, "duration", 1), "output", "")
