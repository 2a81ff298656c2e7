## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{y}] =} centreline (@var{model}, @var{stations}, @var{history}, @var{zoom})
## Points of the centreline in the fixed frame (p-by-m, m) at the @var{stations} (p numbers, m, along the undeformed rod)
## and all m times of @var{history} (phi, V1, V2), with the deformation multiplied by @var{zoom}.
## @end deftypefn

function [x, y] = centreline (model, stations, history, zoom)
  [v1, v2] = deal (zeros (numel (stations), numel (history.phi)));
  if (model.modes(1) > 0)
    [j, xi1] = meshgrid (1:model.modes(1), stations);
    v1 = rod_shape_longitudinal (j, xi1, model.length)*history.V1;
  endif
  if (model.modes(2) > 0)
    [j, xi1] = meshgrid (1:model.modes(2), stations);
    v2 = rod_shape_transversal (j, xi1, model.length)*history.V2;
  endif
  [phi, xi1] = meshgrid (history.phi, stations);
  [x, y] = rod_centreline (phi, xi1, zoom*v1, zoom*v2);
endfunction

%!test # a half wave across the rod, a quarter wave along it, rotated by 90 degrees
%! model = struct ("modes", [1 1], "length", 2);
%! history = struct ("phi", pi/2, "V1", 0.01, "V2", 0.1);
%! [x, y] = centreline (model, [0 1 2], history, 2);
%! assert (x, [0; -0.2; 0], 1e-15);
%! assert (y, [0; 1 + 0.02*sin(pi/4); 2.02], 1e-15);
