## -*- texinfo -*-
## @deftypefn {} {@var{path} =} deep_arch (@var{modes})
## The circular arch of DaDeppo and Schmidt (J. Appl. Mech. 42, 1975) as a path (see @code{load_path}): of the radius
## 1 m and E I = 1 N m^2, over 215 degrees, clamped at its left end, hinged at the right one, under a force downwards
## at its apex, the factor (N).
##
## It is the exact rod on a plane, with so many @var{modes} (polynomials of each coordinate) and E A R^2/EI = 1e4. This
## rod is straight when undeformed; its end moment E I/R at the hinge makes it a circle, and does the same work as a
## curvature 1/R that it were made with.
## @end deftypefn

function path = deep_arch (modes)
  half = 215/2*pi/180;
  scene.surface = struct ("name", "plane", "inclination", 0);
  scene.rod = struct ("length", 2*half, "EA", 1e4, "EI", 1, "rhoA", 1);
  scene.ends = {"clamped", "hinge"};
  scene.initial.shape = @(xi) [sin(xi(:).' - half); cos(xi(:).' - half)];
  [scene.gravity, scene.duration, scene.tip_moment, scene.model.modes] = deal (0, 1, -1, [modes modes]);
  scene = check_surface_scene (scene);
  system = surface_rod (scene);
  arch = surface_at_rest (scene, system);
  apex = surface_basis (scene, system.place, half).values{2}.';
  path = struct ("factors", [0 12], "range", 12, "size", 2, "mass", scene.rod.length, "balance", arch);
  path.balance.residual = @(factor, z, v, lambda) arch.residual (0, z, v, lambda) ...
                                                  - apex*(factor.*ones (1, columns (z)));
  path.balance.tangent = @(factor, z, lambda) arch.tangent (0, z, lambda);
endfunction

%!test # unloaded it rests where it is; it sways to its hinge and turns round at the printed 8.97 E I/R^2
%! path = deep_arch (24);
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
%! assert (numel (limit), 1); assert (limit{1}.event, "limit point"); assert (limit{1}.x(end), 8.97, 0.01);
%! assert (path.balance.shape (limit{1}.x(1:end-1)){1}(21,1) > 0.5);
