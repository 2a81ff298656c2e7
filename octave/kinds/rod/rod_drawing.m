## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} rod_drawing (@var{scene}, @var{model}, @var{history})
## What the pictures show of a run with one rod: the struct that @code{draw_pictures} takes.
## @end deftypefn

function drawing = rod_drawing (scene, model, history)
  stations = linspace (0, model.length, 101).';
  drawing.title = scene.title;
  drawing.time = history.t;
  drawing.frames_per_second = scene.frames_per_second;
  drawing.zoom = scene.zoom;
  drawing.frame_size = scene.frame_size;
  drawing.gravity = scene.gravity;
  drawing.moment = scene.moment (history.t);
  if (! isempty (history.torque))
    drawing.moment = history.torque;
  endif
  drawing.moment_breaks = scene.breaks;
  drawn = @(stations) enlarged (model, stations, history, scene.zoom, ! isempty (scene.rotation));
  [body.x, body.y, body.rest_x, body.rest_y] = drawn (stations);
  body.half_height = scene.rod.half_height;
  if (isempty (body.half_height))
    body.half_height = scene.rod.length/100;
  endif
  body.stress = bending_stress (scene.rod, model, stations, history.V);
  drawing.bodies = body;
  drawing.notes = stress_notes (scene.rod, body);
  drawing.hinges = struct ("x", zeros (size (history.t)), "y", zeros (size (history.t)), "shape", {{"pin"}});
  if (! isempty (scene.rotation))
    drawing.hinges.shape = {"hub"};
  endif
  drawing.hinges = with_pins (drawing.hinges, scene.joints, history.joint_points);
  place = @(~, station) drawn (station);
  drawing.springs = springs_of_joints (scene.joints, place, numel (history.t));
  [drawing.forces, drawing.moments] = loads_of_joints ([force_of(scene), scene.joints(:).'], place, history.t);
  drawing.strips = rod_strips (history, drawing.moment, undeformed_tip (model));
  drawing.equations = {"hinged", "straight"};
  if (! isempty (scene.rod.curvature))
    drawing.equations = {"hinged", "curved"};
  endif
endfunction

## of the scene, as joints have it
function joint = force_of (scene)
  joint = scene.joints([]);
  if (! isempty (scene.force))
    joint(1).kind = "force";
    joint.bodies = [1 0];
    joint.stations = [scene.force_station, 0];
    joint.value = @(t) at_times (scene.force, t);
  endif
endfunction

## of joints, bushings, on the ground
function hinges = with_pins (hinges, joints, points)
  if (! isempty (joints))
    pins = pins_of_joints (joints, points.x, points.y, 0*points.x);
    hinges = struct ("x", [hinges.x; pins.x], "y", [hinges.y; pins.y], "shape", {[hinges.shape; pins.shape]});
  endif
endfunction

%!test
%! [scene, model] = sample_rod ([0 1]);
%! history = setfield (setfield (sample_history (2), "V", [0, 1e-4]), "joint_points", []);
%! [history.phi, history.V_names] = deal ([0 0], {"V2_1"});
%! drawing = rod_drawing (scene, model, history);
%! assert (max (drawing.bodies.stress(:,2)), (1.2e11 + 2*8.1e10)*pi^2*1e-4*0.015, 1);  # (12), with the paper's EI
%! assert (drawing.notes, {});
%! assert (max (drawing.bodies.y(:,2)), 300e-4, 1e-12);
%! scene.joints = struct ("kind", {"spring", "bushing"}, "bodies", [1 0], "stations", [0.2 0], "point", [7 8]);
%! history.joint_points = struct ("x", [1 1; 2 3], "y", [4 4; 5 6]);
%! drawing = rod_drawing (scene, model, history);
%! assert (drawing.hinges.x, [0 0; 2 3; 7 7; 7 7]); assert (drawing.hinges.shape, repmat ({"pin"}, 4, 1));
%! assert ([drawing.springs.to_x, drawing.springs.to_y], [7 7 8 8]); assert (drawing.springs.x, [0.2 0.2], 1e-3);
%!test # a hub, a curved rod, one of no height, and loads
%! [scene, model] = sample_rod ([0 1]);
%! history = setfield (setfield (sample_history (2), "V", [0, 1e-4]), "joint_points", []);
%! [history.phi, history.V_names] = deal ([0 0], {"V2_1"});
%! drawing = rod_drawing (scene, model, history);
%! assert (drawing.hinges.shape, {"pin"}); assert (drawing.equations, {"hinged", "straight"});
%! assert (drawing.bodies.half_height, scene.rod.half_height); assert (drawing.moment, scene.moment (history.t));
%! assert ({drawing.title, drawing.time, drawing.zoom}, {scene.title, history.t, scene.zoom});
%! assert ({drawing.gravity, drawing.moment_breaks}, {scene.gravity, scene.breaks});
%! scene.rotation = @(t) [0 0 0];
%! scene.rod.curvature = 1;
%! scene.rod.half_height = [];
%! history.torque = [3 4];
%! drawing = rod_drawing (scene, model, history);
%! assert (drawing.hinges.shape, {"hub"}); assert (drawing.equations, {"hinged", "curved"});
%! assert (drawing.bodies.half_height, scene.rod.length/100); assert (drawing.moment, [3 4]);
