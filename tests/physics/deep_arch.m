## -*- texinfo -*-
## @deftypefn {} {@var{path} =} deep_arch (@var{modes})
## The circular arch of DaDeppo and Schmidt (J. Appl. Mech. 42, 1975) as a path (see @code{load_path}): of the radius
## 1 m and E I = 1 N m^2, over 215 degrees, clamped at its left end, hinged at the right one, under a force downwards
## at its apex, the factor (N).
##
## It is the exact rod of the scene @code{arch} with so many @var{modes} (polynomials of each coordinate).
## @end deftypefn

function path = deep_arch (modes)
  scene = growing_loads (check_surface_scene (setfield (arch (), "model", "modes", [modes modes])), 0);
  balance = surface_at_rest (scene, surface_rod (scene));
  path = struct ("factors", [0 12], "range", 12, "size", 2, "mass", scene.rod.length, "balance", balance);
endfunction

%!test # unloaded it rests where it is; it sways to its hinge and turns round at the printed 8.97 E I/R^2
%! path = deep_arch (32);
%! ahead = [zeros(path.balance.n, 1); 1];
%! point = path_point (path, 0*ahead, zeros (0, 1), ahead);
%! assert (point.x, 0*ahead, 1e-9);
%! point.tangent = path_tangent (point, ahead);
%! step = path.size/50;
%! do
%!   last = point;
%!   [point, step] = path_step (path, last, step);
%! until (point.unstable > 0)
%! limit = path_events (path, last, point);
%! assert (numel (limit), 1); assert (limit{1}.event, "limit point"); assert (limit{1}.x(end), 8.97, 0.005);
%! assert (path.balance.shape (limit{1}.x(1:end-1)){1}(21,1) > 0.5);
