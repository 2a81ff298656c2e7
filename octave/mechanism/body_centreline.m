## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}] =} body_centreline (@var{model}, @var{stations}, @var{body}, @var{zoom})
## Points of a body's centreline (p-by-m, m) as @code{centreline} has them of a hinged rod, with @var{body}'s phi, V, x, y.
## @end deftypefn

function [x, y] = body_centreline (model, stations, body, zoom)
  [x, y] = centreline (model, stations, body, zoom);
  x += body.x;
  y += body.y;
endfunction
