## -*- texinfo -*-
## @deftypefn {} {[@var{hinges}, @var{springs}, @var{forces}, @var{moments}] =} joint_data (@var{drawing}, @
##   @var{points}, @var{shown}, @var{unit})
## The hinges, springs, forces and moments of joints of a @var{drawing} (see @code{draw_pictures}) for
## @file{report.js}, cells: a hinge's shape, angle (rad) and whether it is on the ground, a spring's shape and its
## ends, from and to, a force's components (N), a moment M (N m).
##
## Each hinge, end and load has its places x and y in the frames @var{shown}, whole numbers of the @var{unit} (m).  It
## goes with the point of a body that it lies on in all frames, at any zoom: body and point, from 0, of at most so many
## @var{points}; else body is -1.
## @end deftypefn

function [hinges, springs, forces, moments] = joint_data (drawing, points, shown, unit)
  place = @(x, y) place_of (drawing.bodies, x, y, points, shown, unit);
  at = drawing.hinges;
  count = rows (at.x);
  hinges = springs = {};
  for i = 1:count
    hinges{i} = place (at.x(i,:), at.y(i,:));
    hinges{i}.shape = field_or (at, "shape", repmat ({"pin"}, count, 1)){i};
    hinges{i}.ground = field_or (at, "ground", true (count, 1))(i);
    hinges{i}.angle = num2cell (round (1e3*field_or (at, "angle", 0*at.x)(i,shown))/1e3);
  endfor
  at = field_or (drawing, "springs", struct ("x", []));
  for i = 1:rows (at.x)
    springs{i} = struct ("shape", at.shape{i}, "from", place (at.x(i,:), at.y(i,:)), ...
                         "to", place (at.to_x(i,:), at.to_y(i,:)));
  endfor
  forces = acting (field_or (drawing, "forces", struct ("x", [])), place, shown);
  moments = acting (field_or (drawing, "moments", struct ("x", [])), place, shown);
endfunction

function data = acting (loads, place, shown)
  data = {};
  for i = 1:rows (loads.x)
    data{i} = place (loads.x(i,:), loads.y(i,:));
    for part = setdiff (fieldnames (loads).', {"x", "y"})
      data{i}.(part{1}) = num2cell (loads.(part{1})(i,shown));
    endfor
  endfor
endfunction

function data = place_of (bodies, x, y, points, shown, unit)
  data = struct ("body", -1, "x", {num2cell(round (x(shown)/unit))}, "y", {num2cell(round (y(shown)/unit))});
  for k = 1:numel (bodies)
    index = evenly_chosen (rows (bodies(k).x), points);
    distance = max (hypot (bodies(k).x(index,:) - x, bodies(k).y(index,:) - y), [], 2);
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
%! first = joint_data (drawing, 41, [1 4], 1e-6){1};
%! assert (first.body, 0); assert (first.point, 0); assert (first.ground, true); assert (first.shape, "hub");
%! assert ([first.y{:}]*1e-6, drawing.hinges.y(1,[1 4]), 1e-6);
%! second = joint_data (drawing, 3, 1:4, 1e-6){2};
%! assert (second.body, 0); assert (second.point, 1); assert (second.ground, false); assert (second.shape, "pin");
%! assert ([second.x{:}]*1e-6, drawing.hinges.x(2,:), 1e-6);
%! drawing.hinges.y(2,3) += 41e-6;
%! assert (joint_data (drawing, 3, 1:4, 1e-6){2}.body, -1);
%!test # a force on the first body's end
%! drawing = sample_bodies (4);
%! [x, y] = deal (drawing.bodies(1).x(end,:), drawing.bodies(1).y(end,:));
%! drawing.forces = struct ("x", x, "y", y, "F_x", [1 2 3 4], "F_y", [5 6 7 8]);
%! force = nthargout (3, @joint_data, drawing, 41, 2:3, 1e-6){1};
%! drawing.moments = struct ("x", x, "y", y, "M", [1 2 3 4]);
%! assert (nthargout (4, @joint_data, drawing, 41, 2:3, 1e-6){1}.M, {2, 3});
%! assert (force.body, 0); assert ([force.F_x{:}, force.F_y{:}], [2 3 6 7]);
%!test # a spring from the second body's end to the ground
%! drawing = sample_bodies (4);
%! [x, y] = deal (drawing.bodies(2).x(end,:), drawing.bodies(2).y(end,:));
%! drawing.springs = struct ("x", x, "y", y, "to_x", 3 + 0*x, "to_y", 4 + 0*x, "shape", {{"coil"}});
%! [~, springs] = joint_data (drawing, 41, 2:3, 1e-6);
%! assert (springs{1}.shape, "coil"); assert ([springs{1}.from.body, springs{1}.from.point], [1 20]);
%! assert (springs{1}.to, struct ("body", -1, "x", {{3e6, 3e6}}, "y", {{4e6, 4e6}}));
%! assert (nthargout (2, @joint_data, sample_bodies (4), 41, 1:4, 1e-6), {});
