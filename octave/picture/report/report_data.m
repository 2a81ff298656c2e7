## -*- texinfo -*-
## @deftypefn {} {@var{json} =} report_data (@var{drawing})
## What the animation of the report draws of @var{drawing} (see @code{draw_pictures}), for @file{report.js}: at most
## 400 frames and 41 points a body. Lengths are whole numbers of @code{unit} (m), deformations as drawn of
## @code{deformation_unit} (m), stresses of 1/255 of the largest.
## @end deftypefn

function json = report_data (drawing)
  shown = evenly_chosen (numel (drawing.time), 400);
  camera = fit_camera (drawing, [1 1]);
  off = arrayfun (@(body) max ([0; abs(body.x(:) - body.rest_x(:)); abs(body.y(:) - body.rest_y(:))]), drawing.bodies);
  data.unit = camera.pixel/20000;
  data.deformation_unit = max ([0, off(:).'])/5000;
  data.zoom = drawing.zoom;
  data.largest_zoom = drawing.zoom*max (2, 0.3*camera.pixel/max ([off(:).', realmin]));
  if (data.deformation_unit == 0)
    data.largest_zoom = 2*drawing.zoom;
  endif
  data.time = num2cell (drawing.time(shown));
  data.decimals = max (2, ceil (log10 (drawing.frames_per_second)));
  ## At its own pace, but no film passes in less than two seconds or takes more than twenty.
  seconds = drawing.time(end) - drawing.time(1);
  data.speed = max (seconds, realmin)/min (max (seconds, 2), 20);
  data.gravity = drawing.gravity;
  data.moment = false;
  if (any (drawing.moment))
    data.moment = num2cell (rounded (drawing.moment(shown)));
  endif
  [stress, range, unit] = body_stress (drawing.bodies);
  data.stress = false;
  if (any (! cellfun (@isempty, stress)))
    data.stress = struct ("range", range, "unit", unit);
  endif
  for i = 1:numel (drawing.bodies)
    data.bodies{i} = body_data (drawing.bodies(i), stress{i}, range, shown, data);
  endfor
  [data.hinges, data.springs, data.forces, data.moments] = joint_data (drawing, 41, shown, data.unit);
  data.backdrop = cellfun (@(line) num2cell (round (line.'(:).'/data.unit)), field_or (drawing, "backdrop", {}), ...
                           "UniformOutput", false);
  data.strips = arrayfun (@(strip) values_of_strip (strip, shown), drawing.strips(:).', "UniformOutput", false);
  json = strrep (jsonencode (data), "</", "<\\/");
endfunction

function values = rounded (values)
  unit = 10^floor (log10 (max ([abs(values(:)); 1e-300])) - 5);
  values = round (values/unit)*unit;
endfunction

## x and y in turn, a row vector of whole numbers a frame
function frames = whole_numbers (x, y, unit)
  if (unit > 0)
    x /= unit;
    y /= unit;
  endif
  pairs = round (reshape (permute (cat (3, x, y), [3 1 2]), 2*rows (x), columns (x)));
  frames = num2cell (pairs.', 2).';
endfunction

function data = body_data (body, stress, range, shown, units)
  points = evenly_chosen (rows (body.x), 41);
  pick = @(values) values(points,shown);
  data.half_height = body.half_height;
  data.rest = whole_numbers (pick (body.rest_x), pick (body.rest_y), units.unit);
  data.deformation = whole_numbers (pick (body.x - body.rest_x), pick (body.y - body.rest_y), units.deformation_unit);
  data.stress = false;
  if (! isempty (stress))
    data.stress = num2cell (round (255*(pick (stress) - range(1))/diff (range)).', 2).';
  endif
endfunction

function data = values_of_strip (strip, shown)
  [data.label, values] = scaled_panel (strip);
  data.names = strip.names;
  data.range = padded_range (values);
  data.values = cellfun (@num2cell, num2cell (rounded (values(:,shown)), 2).', "UniformOutput", false);
endfunction

%!test # it parses, and gives the centreline back at the drawn zoom and at rest
%! drawing = sample_drawing (7);
%! data = jsondecode (report_data (drawing));
%! rest = data.bodies.rest*data.unit;
%! drawn = rest + data.bodies.deformation*data.deformation_unit;
%! assert (rest(3,1:2:end), drawing.bodies.rest_x(:,3).', 1e-4);
%! assert (drawn(3,2:2:end), drawing.bodies.y(:,3).', 2e-4);
%! assert (data.hinges.body, 0); assert (data.hinges.point, 0);
%! assert (data.bodies.stress(3,:), 255*drawing.bodies.stress(:,3).'/max (drawing.bodies.stress(:)), 0.5001);
%! assert (numel (data.strips), 3);
%! drawing.hinges.y += 1;  # beside the body
%! assert (jsondecode (report_data (drawing)).hinges.body, -1);
%!test # nothing but zeros
%! drawing = sample_drawing (2);
%! drawing.strips(1).values = [0 0];
%! assert (isempty (strfind (report_data (drawing), "null")));
%!test # two bodies: the pin is the end of the first
%! data = jsondecode (report_data (sample_bodies (4)));
%! assert ([data.hinges.body], [0 0]); assert ([data.hinges.point], [0 1]);
%! assert ([data.hinges.ground], [true false]);
%! assert (data.stress, false);
%!test # lines behind a rod on a surface
%! data = jsondecode (report_data (sample_surface (4)));
%! assert (data.backdrop(2,:)*data.unit, sample_surface (4).backdrop{2}.'(:).', 1e-3);
%!test # a text cannot end the script that it stands in
%! drawing = sample_drawing (1);
%! drawing.strips(1).label = "</script>";
%! assert (isempty (strfind (report_data (drawing), "</")));
%!test # what is written is what is drawn: times, strips, the moment, the range of zooms, and the pace
%! drawing = sample_drawing (7);
%! data = jsondecode (report_data (drawing));
%! assert (data.time.', drawing.time, 1e-12); assert (data.zoom, 300); assert (data.gravity, 9.81);
%! assert (data.moment, false);
%! for k = 1:3
%!   [label, values] = scaled_panel (drawing.strips(k));
%!   assert (data.strips(k).label, label); assert (data.strips(k).range.', padded_range (values), 1e-12);
%!   assert (data.strips(k).values, values, 2e-5*max (abs (values(:))));
%! endfor
%! assert (data.decimals, 2); assert (data.speed, range (drawing.time)/2, 1e-12);
%! drawing.time = 30*drawing.time/range (drawing.time);
%! drawing.moment = [0 1 2 3.14159265 0 -400 0];
%! drawing.frames_per_second = 1001;
%! data = jsondecode (report_data (drawing));
%! assert (data.speed, 1.5, 1e-12); assert (data.decimals, 4);
%! assert (data.moment.', [0 1 2 3.142 0 -400 0], 1e-12);
%! camera = fit_camera (drawing, [1 1]);
%! off = max (hypot (drawing.bodies.x - drawing.bodies.rest_x, drawing.bodies.y - drawing.bodies.rest_y)(:));
%! assert (data.largest_zoom >= 600 && data.largest_zoom/300*off >= 0.3*camera.pixel);
%! drawing.bodies.x = drawing.bodies.rest_x;
%! drawing.bodies.y = drawing.bodies.rest_y;
%! drawing.moment = zeros (1, 7);
%! data = jsondecode (report_data (drawing));
%! assert (data.largest_zoom, 600); assert (data.moment, false); assert (data.deformation_unit, 0);
%!test # of many frames and points 400 and 41 are shown, the first and the last among them
%! drawing = sample_drawing (900);
%! data = jsondecode (report_data (drawing));
%! assert (size (data.bodies.rest), [400 82]); assert (data.time([1 end]).', drawing.time([1 end]), 1e-12);
