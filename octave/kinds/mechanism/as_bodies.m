## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} as_bodies (@var{given})
## A scene of one rod with @code{joints} that constrain it (a slider, say) as a scene of one body: its hinge at O, or,
## with a rotation, the hub that turns its tangent there, its moment and its force are joints of it, beside those
## given, which are on it where they do not say on which body.  Scenes that have bodies, or no rod, come back as they
## are.
## @end deftypefn

function scene = as_bodies (given)
  scene = given;
  if (isfield (given, "bodies") || ! isfield (given, "rod"))
    return;
  endif
  own = {"rod", "tip_mass", "initial", "model"};
  short = {"rotation", "moment", "moment_breaks", "force", "force_station", "joints"};
  for name = intersect (own, fieldnames (given)).'
    body.(name{1}) = given.(name{1});
  endfor
  scene = rmfield (given, intersect ([own, short], fieldnames (given)));
  if (isfield (body, "initial") && isstruct (body.initial) && isfield (body.initial, "from"))
    scene.initial.from = body.initial.from;
    body.initial = rmfield (body.initial, "from");
  endif
  if (isfield (given, "rotation") && is_function_handle (given.rotation))
    body = turned_at_first (body, given.rotation (0));
  endif
  scene.bodies = {body};
  scene.joints = [{struct("name", "hinge", "kind", "revolute", "bodies", 1, "stations", 0)}, loads_of(given), ...
                  numbered(on_one_body (field_or (given, "joints", {})))];
  if (isfield (given, "moment_breaks"))
    scene.breaks = given.moment_breaks;
  endif
endfunction

## those given, as they are numbered there
function joints = numbered (joints)
  for k = 1:numel (joints)
    if (isstruct (joints{k}) && isempty (field_or (joints{k}, "name", "")))
      joints{k}.name = sprintf ("joint %d", k);
    endif
  endfor
endfunction

## where the hub has it, unless it says otherwise
function body = turned_at_first (body, turn)
  names = {"phi", "phi_dot"};
  for k = find (numel (turn) == 3 & ! isfield (field_or (body, "initial", struct ()), names))
    body.initial.(names{k}) = turn(k);
  endfor
endfunction

function joints = loads_of (given)
  joints = {};
  if (isfield (given, "rotation") && ! isempty (given.rotation))
    joints{end+1} = struct ("name", "rotation", "kind", "angle", "bodies", 1, "stations", 0, "value", given.rotation);
  endif
  if (isfield (given, "moment"))
    joints{end+1} = struct ("name", "moment", "kind", "moment", "bodies", 1, "stations", 0, "value", given.moment);
  endif
  if (isfield (given, "force") && ! isempty (given.force))
    station = [];  # the tip, where the rod has a length
    if (isfield (given.rod, "length"))
      station = given.rod.length;
    endif
    if (isfield (given, "force_station") && ! isempty (given.force_station))
      station = given.force_station;
    endif
    joints{end+1} = struct ("name", "force", "kind", "force", "bodies", 1, "stations", station, "value", given.force);
  endif
endfunction

%!function scene = hinged ()
%!  scene.rod = struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1, "half_height", 0.005);
%!  scene.model = struct ("modes", [0 2], "energy", "uniaxial", "rotary_inertia", false, "stiffening", "none");
%!  [scene.gravity, scene.duration, scene.frames_per_second, scene.solver.tolerance] = deal (0, 0.2, 20, 1e-7);
%!  scene.initial.phi_dot = 0.1;
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
%!error <bodies is missing: it takes struct array> driver (struct ("joints", {{}}, "duration", 1), "output", "")
