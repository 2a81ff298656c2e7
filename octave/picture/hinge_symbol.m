## -*- texinfo -*-
## @deftypefn {} {[@var{ground}, @var{pins}] =} hinge_symbol (@var{hinges}, @var{frame}, @var{size})
## Polylines (n-by-2, m, with rows of NaN between them) of the hinges in one @var{frame}: @var{pins} are the outlines
## of their @code{shape} at their angle (see @code{draw_pictures}), @var{ground} the hatched supports of those on the
## ground: walls behind welds, and triangles.
## @end deftypefn

function [ground, pins] = hinge_symbol (hinges, frame, size)
  count = rows (hinges.x);
  on_ground = field_or (hinges, "ground", true (count, 1));
  shape = field_or (hinges, "shape", repmat ({"pin"}, count, 1));
  angle = field_or (hinges, "angle", 0*hinges.x);
  ground = pins = zeros (0, 2);
  for i = 1:count
    place = [hinges.x(i,frame), hinges.y(i,frame)];
    turn = [cos(angle(i,frame)), sin(angle(i,frame)); -sin(angle(i,frame)), cos(angle(i,frame))];
    pins = [pins; place + size*outline(shape{i})*turn; NaN(1, 2)];
    if (on_ground(i) && strcmp (shape{i}, "weld"))
      ground = [ground; place + size*wall()*turn; NaN(1, 2)];
    elseif (on_ground(i))
      ground = [ground; place + size*support(); NaN(1, 2)];
    endif
  endfor
endfunction

function lines = outline (shape)
  angle = linspace (0, 2*pi, 25).';
  circle = [cos(angle), sin(angle)];
  corners = [1 1; -1 1; -1 -1; 1 -1; 1 1];
  lines = struct ("pin", 0.4*circle, "hub", 0.9*circle, "block", corners.*[0.9, 0.6], "weld", 0.3*corners).(shape);
endfunction

function lines = support ()
  lines = [0 0; -1 -1.6; 1 -1.6; 0 0; NaN NaN; -1.4 -1.6; 1.4 -1.6];
  for foot = -1:0.6:1.4
    lines = [lines; NaN NaN; foot -1.6; foot-0.5 -2.1];
  endfor
endfunction

## across what begins there
function lines = wall ()
  lines = [0 -1.4; 0 1.4];
  for foot = -1:0.6:1.4
    lines = [lines; NaN NaN; 0 foot; -0.5 foot-0.5];
  endfor
endfunction

%!test # a pin between bodies has no support
%! hinges = struct ("x", [0 0; 1 2], "y", [0 0; 0 0], "ground", [true; false]);
%! [ground, pins] = hinge_symbol (hinges, 2, 0.1);
%! assert (ground(! isnan (ground(:,1)),1) < 1);
%! assert (max (pins(:,1)), 2.04, 1e-12);
%!test # all are on the ground where nothing is said
%! assert (max (hinge_symbol (struct ("x", [0; 1], "y", [0; 0]), 1, 0.1)(:,1)) > 1);
%!test # a block that slides is wider than high
%! [~, pins] = hinge_symbol (struct ("x", 1, "y", 0, "ground", false, "shape", {{"block"}}), 1, 0.1);
%! assert (max (pins), [1.09, 0.06], 1e-12);
%!test # the ground: a triangle below the pin on a line with five strokes; a pin is round, a hub more so, a weld square
%! [ground, pins] = hinge_symbol (struct ("x", 0, "y", 0), 1, 1);
%! assert (ground(1:4,:), [0 0; -1 -1.6; 1 -1.6; 0 0]); assert (ground(6:7,:), [-1.4 -1.6; 1.4 -1.6]);
%! strokes = ground(! isnan (ground(:,1)),:)(7:end,:);
%! assert (strokes(1:2:end,:), [(-1:0.6:1.4).', -1.6*ones(5, 1)], 1e-12);
%! assert (strokes(2:2:end,:), strokes(1:2:end,:) - [0.5 0.5], 1e-12);
%! assert (hypot (pins(1:25,1), pins(1:25,2)), 0.4*ones (25, 1), 1e-12); assert (sum (isnan (pins(:,1))), 1);
%! [~, pins] = hinge_symbol (struct ("x", 0, "y", 0, "shape", {{"hub"}}), 1, 1);
%! assert (hypot (pins(1:25,1), pins(1:25,2)), 0.9*ones (25, 1), 1e-12);
%! [~, pins] = hinge_symbol (struct ("x", 0, "y", 0, "shape", {{"weld"}}), 1, 1);
%! assert (pins(1:5,:), 0.3*[1 1; -1 1; -1 -1; 1 -1; 1 1], 1e-12);
%!test # a block along a guide that climbs by 30 degrees, and a wall behind what stands upright on it
%! [~, pins] = hinge_symbol (struct ("x", 0, "y", 0, "ground", false, "shape", {{"block"}}, "angle", pi/6), 1, 1);
%! assert (pins(1,:), [0.9*cosd(30) - 0.3, 0.9*sind(30) + 0.6*cosd(30)], 1e-12);
%! [ground, pins] = hinge_symbol (struct ("x", 0, "y", 0, "shape", {{"weld"}}, "angle", pi/2), 1, 1);
%! assert (ground(1:2,:), [1.4 0; -1.4 0], 1e-12); assert (min (ground(:,2)), -0.5, 1e-12);
