## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}] =} body_centreline (@var{model}, @var{stations}, @var{body}, @var{zoom})
## Points of a body's centreline (p-by-m, m) as @code{centreline} has them of a hinged rod, with @var{body}'s
## phi, V, x, y.
## @end deftypefn

function [x, y] = body_centreline (model, stations, body, zoom)
  [x, y] = model.equations.centreline (model, stations, body, zoom);
  x += body.x;
  y += body.y;
endfunction

%!test
%! model = struct ("base", base_functions ([], 1, 2), "shortening", 0, "equations", matrix_equations ());
%! [x, y] = body_centreline (model, [0 1 2], struct ("phi", pi/2, "V", 0.1, "x", 3, "y", 4), 1);
%! assert ([x, y], [3 4; 2.9 5; 3 6], 1e-12);
