## -*- texinfo -*-
## @deftypefn {} {[@var{Q}, @var{torque}, @var{force}] =} loads_on_surface (@var{system}, @var{t}, @var{z})
## Generalized forces @var{Q} (n-by-m) of the loads on a rod on a surface (see @code{surface_rod}) at the times @var{t}
## and places @var{z} (n-by-m), m of them or several times as many, their @var{torque} about the chart's origin
## (1-by-m, N m; of a rod in a hub) and the sum of their @var{force}s (3-by-m, N).
## @end deftypefn

function [Q, torque, force] = loads_on_surface (system, t, z)
  loads = system.loads;
  if (isempty (loads.values))
    Q = 0*z;
    torque = 0;
    force = zeros (3, columns (z));
    return;
  endif
  places = numel (loads.stations);
  values = zeros (4*places, numel (t));
  for k = 1:numel (loads.values)
    values(loads.rows{k},:) += reshape (loads.values{k} (t), [], numel (t));
  endfor
  values = repmat (values, 1, columns (z)/numel (t));
  of = @(k) values((k - 1)*places + (1:places),:);
  b = loads.base;
  acting = struct ("force_1", of (1), "force_2", of (2), "force_3", of (3), "moment", of (4));
  turn = system.turn (t, z);
  fields = fields_of_basis (b, z, z, z, turn);
  [d{1:4}] = system.surface.point_loads (fields, acting);
  [Q, torque] = work_on_base (b, d, fields, turn);
  force = [sum(of (1), 1); sum(of (2), 1); sum(of (3), 1)];
endfunction

%!test # a force and moments at several places, two of them at one, as work per rotation, at two times
%! joint = @(kind, station, value) struct ("kind", kind, "stations", station, "value", value);
%! scene = on_level_plane ("force", @(t) [0 t 7], "moment", 3, "tip_moment", @(t) 2*t);
%! scene.joints = {joint("force", 0.5, [1 4 0]), joint("moment", 0.5, 5)};
%! system = surface_rod (check_surface_scene (scene));
%! spin = system.place.basis.'*[0 0 0 1 1 0].';
%! [Q, ~, force] = loads_on_surface (system, [0 1], zeros (system.n, 2));
%! assert (spin.'*Q, [3 + 2 + 5, 3 + 2 + 5 + 2 + 2], 1e-12);
%! assert (force, [1 1; 4 5; 7 7], 1e-12);
%!test # none
%! system = surface_rod (check_surface_scene (on_level_plane ()));
%! [Q, ~, force] = loads_on_surface (system, [0 1], zeros (system.n, 2));
%! assert (Q, zeros (system.n, 2)); assert (force, zeros (3, 2));
