## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}] =} centreline (@var{model}, @var{stations}, @var{history}, @var{zoom})
## Points of the centreline in the fixed frame (p-by-m, m) at the @var{stations} (p numbers, m, along the undeformed
## rod) and all m times of @var{history} (phi, V), with the deformation multiplied by @var{zoom}.
## @end deftypefn

function [x, y] = centreline (model, stations, history, zoom)
  [along, across] = functions_at (model.base, stations);
  v1 = along*history.V;
  v2 = across*history.V;
  if (model.shortening && ! isempty (model.base.transversal))
    for i = 1:numel (stations)
      v1(i,:) -= sum (history.V.*(shortening_at (model.base, stations(i))*history.V), 1)/2;
    endfor
  endif
  [x_0, y_0] = undeformed_places (model.base, stations);
  [phi, xi1] = meshgrid (history.phi, x_0);
  [x, y] = rod_centreline (phi, xi1, zoom*v1, y_0(:) + zoom*v2);
endfunction

%!test # a half wave across the rod, a quarter wave along it, rotated by 90 degrees
%! model = struct ("base", base_functions (1, 1, 2), "shortening", 0);
%! history = struct ("phi", pi/2, "V", [0.01; 0.1]);
%! [x, y] = centreline (model, [0 1 2], history, 2);
%! assert (x, [0; -0.2; 0], 1e-15);
%! assert (y, [0; 1 + 0.02*sin(pi/4); 2.02], 1e-15);
%!test # with foreshortening its length stays, up to the fourth order of the slope
%! model = struct ("base", base_functions ([], [1 -1], 2), "shortening", 1);
%! for amplitude = [0.01 0.02]
%!   [x, y] = centreline (model, linspace (0, 2, 2001), struct ("phi", 1, "V", amplitude*[1; 2]), 1);
%!   excess = sum (hypot (diff (x), diff (y))) - 2;
%!   assert (abs (excess) < 100*amplitude^4);
%! endfor
