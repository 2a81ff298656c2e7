## -*- texinfo -*-
## @deftypefn {} {@var{drawing} =} mechanism_drawing (@var{scene}, @var{mechanism}, @var{history})
## What the pictures show of a mechanism's run: the struct that @code{draw_pictures} takes.
## @end deftypefn

function drawing = mechanism_drawing (scene, mechanism, history)
  frames = numel (history.t);
  drawing = struct ("title", scene.title, "time", history.t, "frames_per_second", scene.frames_per_second, ...
                    "frame_size", scene.frame_size, "zoom", scene.zoom, "gravity", scene.gravity, ...
                    "moment", zeros (1, frames), "moment_breaks", scene.breaks);
  for k = 1:numel (history.bodies)
    model = mechanism.models{k};
    rod = scene.bodies(k).rod;
    stations = linspace (0, model.length, 41).';
    body = struct ("half_height", rod.half_height);
    if (isempty (rod.half_height))
      body.half_height = rod.length/100;
    endif
    clamped = is_cantilever (scene.joints, k);
    drawn{k} = @(stations) enlarged (model, stations, history.bodies(k), scene.zoom, clamped);
    [body.x, body.y, body.rest_x, body.rest_y] = drawn{k}(stations);
    body.stress = bending_stress (rod, model, stations, history.bodies(k).V);
    drawing.bodies(k) = body;
  endfor
  drawing.notes = stress_notes ([scene.bodies.rod], drawing.bodies);
  of_joints = mechanism.marker_of(:,1);
  guides = of_joints;
  slides = strcmp ({scene.joints.kind}, "slider");
  guides(slides) = mechanism.marker_of(slides,2);
  drawing.hinges = pins_of_joints (scene.joints, history.markers.x(of_joints,:), history.markers.y(of_joints,:), ...
                                   history.markers.angle(guides,:));
  place = @(k, station) drawn{k}(station);
  drawing.springs = springs_of_joints (scene.joints, place, frames);
  [drawing.forces, drawing.moments] = loads_of_joints (scene.joints, place, history.t);
  drawing.strips = mechanism_panels (scene, history, {"angles", "tips", "reactions"});
  curved = arrayfun (@(body) ! isempty (body.rod.curvature), scene.bodies);
  drawing.equations = {"mechanism"};
  if (! all (curved))
    drawing.equations{end+1} = "straight";
  endif
  if (any (curved))
    drawing.equations{end+1} = "curved";
  endif
endfunction

## which is held at O alone, with its tangent: the ends of others are where they are, so that drawn bodies meet
function yes = is_cantilever (joints, k)
  yes = false;
  for joint = joints(:).'
    for station = joint.stations(joint.bodies == k)
      if (station > 0 && (! is_load (joint) && isempty (strfind (joint.kind, "spring"))))
        yes = false;
        return;
      endif
      yes = yes || any (strcmp (joint.kind, {"weld", "angle"}));
    endfor
  endfor
endfunction

%!test # what is welded at O alone is enlarged from its tangent there
%! rod = struct ("length", 1, "EA", 1e4, "EI", 1, "rhoA", 1);
%! scene.bodies = {struct("rod", rod, "model", struct ("modes", [0 2]))};
%! weld = struct ("kind", "weld", "bodies", 1, "stations", 0);
%! for joints = {{weld}, {weld, struct("kind", "slider", "bodies", 1, "stations", 1)}}
%!   scene.joints = joints{1};
%!   [scene.zoom, scene.duration] = deal (10, 1);
%!   [start, ~, system] = assembled (scene, 0);
%!   start.q(1:2) = [0.01 0.01];
%!   history = measure_mechanism (system, 0, start);
%!   body = mechanism_drawing (check_mechanism (scene), system.mechanism, history).bodies;
%!   clamped(numel (joints{1})) = abs (atan2 (body.rest_y(end), body.rest_x(end)) - history.bodies.psi) < 1e-12;
%! endfor
%! assert (clamped, [true false]);
%!test
%! [system, start, scene] = sample_mechanism ([0 1]);
%! history = measure_mechanism (system, 0, start);
%! drawing = mechanism_drawing (scene, system.mechanism, history);
%! assert (numel (drawing.bodies), 3); assert (! isempty (drawing.bodies(1).x));
%! assert (drawing.hinges.ground, [true; false; false; true]);  # the last one is a spring's
%! assert (drawing.springs.shape, {"spiral"; "coil"}); assert (rows (drawing.forces.x) > 0);
%! assert (drawing.equations, {"mechanism", "straight"});
%!test # bodies of no height are drawn a hundredth of their length thick; curved ones have their equations
%! [system, start, scene] = sample_mechanism ([0 1]);
%! history = measure_mechanism (system, 0, start);
%! drawing = mechanism_drawing (scene, system.mechanism, history);
%! assert ([drawing.bodies.half_height], [1 1 1]*scene.bodies(1).rod.length/100, 1e-15);
%! assert (drawing.moment, 0); assert (drawing.hinges.shape, {"pin"; "pin"; "block"; "pin"});
%! scene.bodies(1).rod.half_height = 0.02;
%! scene.bodies(1).rod.curvature = 1;
%! drawing = mechanism_drawing (scene, system.mechanism, history);
%! assert (drawing.bodies(1).half_height, 0.02); assert (drawing.equations, {"mechanism", "straight", "curved"});
%! [scene.bodies.rod] = deal (scene.bodies(1).rod);
%! assert (mechanism_drawing (scene, system.mechanism, history).equations, {"mechanism", "curved"});
