## -*- texinfo -*-
## @deftypefn {} {@var{camera} =} fit_camera (@var{drawing}, @var{panel})
## The ranges @code{x} and @code{y} (1-by-2, m) of a @var{panel} (width and height in pixels) that contain all that is
## drawn in any frame, with a margin and equal scales; @code{pixel} is the length of a pixel (m), and
## @code{symbol} the size of the hinge symbols (m).
## @end deftypefn

function camera = fit_camera (drawing, panel)
  [x, y] = body_points (drawing.bodies);
  span = max (max (x) - min (x), max (y) - min (y));
  camera.symbol = 0.03 * span;
  reach = 2.5 * camera.symbol;
  x = [x; drawing.hinges.x(:) - reach; drawing.hinges.x(:) + reach];
  y = [y; drawing.hinges.y(:) - reach; drawing.hinges.y(:) + reach];
  [tails_x, tails_y] = force_tails (drawing, 1.8*camera.symbol);
  acting = field_or (drawing, "moments", struct ("x", [], "y", []));
  around = 4.5*camera.symbol*[-1, 1];
  x = [x; tails_x(:); vec(acting.x(:) + around)];
  y = [y; tails_y(:); vec(acting.y(:) + around)];
  if (any (drawing.moment) && ! isempty (drawing.hinges.x))
    ## The moment's arrow and its value stand around O.
    x = [x; drawing.hinges.x(1,:).' - 0.4*span; drawing.hinges.x(1,:).' + 0.4*span];
    y = [y; drawing.hinges.y(1,:).' - 0.2*span; drawing.hinges.y(1,:).' + 0.2*span];
  endif
  low = [min(x), min(y)];
  high = [max(x), max(y)];
  camera.pixel = 1.06 * max ((high - low) ./ panel);
  centre = (low + high) / 2;
  camera.x = centre(1) + camera.pixel * panel(1) * [-0.5, 0.5];
  camera.y = centre(2) + camera.pixel * panel(2) * [-0.5, 0.5];
endfunction

function [x, y] = body_points (bodies)
  x = y = [];
  for body = bodies(:).'
    around = body.half_height * [-1, 1];
    x = [x; vec([body.x(:); body.rest_x(:)] + around)];
    y = [y; vec([body.y(:); body.rest_y(:)] + around)];
  endfor
endfunction

%!test # equal scales, everything inside
%! drawing = sample_drawing (50);
%! camera = fit_camera (drawing, [600 400]);
%! assert (diff (camera.x) / 600, diff (camera.y) / 400, 1e-12);
%! assert (diff (camera.x) / 600, camera.pixel, 1e-12);
%! assert (camera.x(1) < min (drawing.bodies.x(:)) && camera.x(2) > max (drawing.bodies.x(:)));
%! assert (camera.y(1) < min (drawing.bodies.y(:)) && camera.y(2) > max (drawing.bodies.y(:)));
%!test # a rod from 0 to 1 m of half height 0.05 m: 6 percent more than that, than its hinge, and than its moment takes
%! body = struct ("x", [0; 1], "y", [0; 0], "rest_x", [0; 1], "rest_y", [0; 0], "half_height", 0.05);
%! drawing = struct ("bodies", body, "hinges", struct ("x", zeros (0, 1), "y", zeros (0, 1)), "moment", 1);
%! camera = fit_camera (drawing, [200 100]);
%! assert (camera.symbol, 0.033, 1e-12); assert (camera.pixel, 1.06*1.1/200, 1e-12);
%! assert ([camera.x, camera.y], [0.5 0.5 0 0] + 1.06*1.1/2*[-1 1 -0.5 0.5], 1e-12);
%! [drawing.hinges.x, drawing.hinges.y, drawing.moment] = deal (0, 0, 0);
%! camera = fit_camera (drawing, [200 100]);
%! assert (mean ([camera.x; camera.y], 2), [(1.05 - 2.5*0.033)/2; 0], 1e-12);
%! assert (camera.pixel, 1.06*(1.05 + 2.5*0.033)/200, 1e-12);
%! assert (fit_camera (drawing, [900 100]).pixel, 1.06*5*0.033/100, 1e-12);
%! drawing.moment = 1;
%! camera = fit_camera (drawing, [200 100]);
%! assert (camera.pixel, 1.06*(1.05 + 0.44)/200, 1e-12);
%! assert (fit_camera (drawing, [900 100]).pixel, 1.06*0.44/100, 1e-12);
