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
    [body.x, body.y] = body_centreline (model, stations, history.bodies(k), scene.zoom);
    [body.rest_x, body.rest_y] = body_centreline (model, stations, history.bodies(k), 0);
    body.stress = bending_stress (rod, model, stations, history.bodies(k).V);
    drawing.bodies(k) = body;
  endfor
  drawing.notes = stress_notes ([scene.bodies.rod], drawing.bodies);
  of_joints = mechanism.marker_of(:,1);
  drawing.hinges = pins_of_joints (scene.joints, history.markers.x(of_joints,:), history.markers.y(of_joints,:));
  place = @(k, station) body_centreline (mechanism.models{k}, station, history.bodies(k), scene.zoom);
  drawing.springs = springs_of_joints (scene.joints, place, frames);
  [drawing.forces, drawing.moments] = loads_of_joints (scene.joints, place, history.t);
  drawing.strips = mechanism_panels (scene, mechanism, history, {"angles", "tips", "reactions"});
  curved = arrayfun (@(body) ! isempty (body.rod.curvature), scene.bodies);
  drawing.equations = {"mechanism"};
  if (! all (curved))
    drawing.equations{end+1} = "straight";
  endif
  if (any (curved))
    drawing.equations{end+1} = "curved";
  endif
endfunction

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
