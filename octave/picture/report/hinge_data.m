## -*- texinfo -*-
## @deftypefn {} {@var{data} =} hinge_data (@var{drawing}, @var{i}, @var{points}, @var{shown}, @var{unit})
## The i-th hinge of a @var{drawing} (see @code{draw_pictures}) for @file{report.js}: its shape, whether it is on the
## ground, and its places x and y in the frames @var{shown}, whole numbers of the @var{unit} (m).  It goes with the
## point of a body that it lies on in all frames, at any zoom: body and point, from 0, of at most so many @var{points};
## else body is -1.
## @end deftypefn

function data = hinge_data (drawing, i, points, shown, unit)
  x = drawing.hinges.x(i,:);
  y = drawing.hinges.y(i,:);
  count = rows (drawing.hinges.x);
  data = struct ("body", -1, "shape", field_or (drawing.hinges, "shape", repmat ({"pin"}, count, 1)){i}, ...
                 "ground", field_or (drawing.hinges, "ground", true (count, 1))(i));
  data.x = num2cell (round (x(shown)/unit));
  data.y = num2cell (round (y(shown)/unit));
  for k = 1:numel (drawing.bodies)
    body = drawing.bodies(k);
    index = evenly_chosen (rows (body.x), points);
    distance = max (hypot (body.x(index,:) - x, body.y(index,:) - y), [], 2);
    [nearest, point] = min (distance);
    if (nearest < 40*unit)
      data.body = k - 1;
      data.point = point - 1;
      return;
    endif
  endfor
endfunction

%!test # at the ends of the first of two bodies, and beside both
%! drawing = sample_bodies (4);
%! drawing.hinges.shape = {"hub", "pin"};
%! first = hinge_data (drawing, 1, 41, [1 4], 1e-6);
%! assert (first.body, 0); assert (first.point, 0); assert (first.ground, true); assert (first.shape, "hub");
%! second = hinge_data (drawing, 2, 3, 1:4, 1e-6);
%! assert (second.body, 0); assert (second.point, 1); assert (second.ground, false); assert (second.shape, "pin");
%! assert ([second.x{:}]*1e-6, drawing.hinges.x(2,:), 1e-6);
%! assert ([first.y{:}]*1e-6, drawing.hinges.y(1,[1 4]), 1e-6);
%! drawing.hinges.y(2,3) += 41e-6;
%! assert (hinge_data (drawing, 2, 3, 1:4, 1e-6).body, -1);
