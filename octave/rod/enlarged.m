## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}, @var{rest_x}, @var{rest_y}] =} enlarged (@var{model}, @var{stations}, @var{body}, @
##   @var{zoom}, @var{clamped})
## Points of the centreline (p-by-m, m) of a @var{body} (phi, V, and where it does not turn about the origin x and y)
## as pictures have them, with the deformation times @var{zoom}, and undeformed.  A rod that is @var{clamped} at O is
## enlarged from the line along its tangent there, so that it leaves its clamp as it does; others from their frame,
## which is the chord of sines.
## @end deftypefn

function [x, y, rest_x, rest_y] = enlarged (model, stations, body, zoom, clamped)
  if (clamped)
    along_tangent = setfield (setfield (body, "phi", body.psi - undeformed_turn (model)), "V", 0*body.V);
    [rest_x, rest_y] = model.equations.centreline (model, stations, along_tangent, 0);
    [x, y] = model.equations.centreline (model, stations, body, 1);
    x = rest_x + zoom*(x - rest_x);
    y = rest_y + zoom*(y - rest_y);
  else
    [rest_x, rest_y] = model.equations.centreline (model, stations, body, 0);
    [x, y] = model.equations.centreline (model, stations, body, zoom);
  endif
  if (isfield (body, "x"))
    x += body.x;
    rest_x += body.x;
    y += body.y;
    rest_y += body.y;
  endif
endfunction

## of the tangent at O against the frame
function angle = undeformed_turn (model)
  [~, ~, angle] = undeformed_places (model.base, 0);
endfunction

%!test # a clamped rod leaves its clamp along its tangent, however much it is enlarged; its chord's ends stay
%! model = struct ("base", base_functions ([], 1, 2), "shortening", 0, "equations", matrix_equations ());
%! slope = 0.01*pi/2;
%! body = struct ("phi", 0.3 - slope, "V", 0.01, "psi", 0.3);
%! [x, y, rest_x, rest_y] = enlarged (model, [0 1e-6 2], body, 5, true);
%! assert ([rest_x(3), rest_y(3)], 2*[cos(0.3), sin(0.3)], 1e-12);
%! assert (atan2 (y(2) - y(1), x(2) - x(1)), 0.3, 1e-3*slope);
%! assert (complex (x(3), y(3)), 2*exp (0.3i) + 5*2*(exp (1i*(0.3 - slope)) - exp (0.3i)), 1e-12);
%! [x, y, rest_x] = enlarged (model, [0 1 2], setfield (setfield (body, "x", 7), "y", 8), 5, false);
%! assert (complex (x(3), y(3)), 7 + 8i + 2*exp (1i*(0.3 - slope)), 1e-12); assert (rest_x(1), 7, 1e-12);
