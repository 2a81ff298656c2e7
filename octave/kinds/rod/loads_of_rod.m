## -*- texinfo -*-
## @deftypefn {} {@var{loads} =} loads_of_rod (@var{t}, @var{motion}, @var{c})
## The loads of a rod as its equations take them, at the times @var{t} (1-by-m) with the @var{motion}, a struct of phi
## (1-by-m) and V (n-by-m): moment, and work_V, work_phi, inertia, inertia_phi, inertia_t of the force (see
## @code{rod_point_force}; zeros without one).  @var{c} comes from @code{rod_constants}.
## @end deftypefn

function loads = loads_of_rod (t, motion, c)
  if (isempty (c.force))
    loads.moment = c.moment (t);
    loads.work_V = 0*motion.V;
    loads.work_phi = loads.inertia = loads.inertia_phi = loads.inertia_t = 0*motion.phi;
    return;
  endif
  loads = setfield (force_at (t, c), "moment", c.moment (t));
  [loads.work_V, loads.work_phi, loads.inertia, loads.inertia_phi, loads.inertia_t] = rod_point_force (
    motion, c.gravity, loads, c.point);
endfunction

%!test # across a rigid rod that lies: a lever
%! scene = setfield (paper (), "force", @(t) [3 5]); scene.force_station = 0.5; scene.model.modes = [0 0];
%! scene = check_scene (scene);
%! c = rod_constants (scene, build_model (scene, rung_of_scene (scene)));
%! motion = struct ("phi", [0 pi/2], "V", zeros (0, 2));
%! loads = loads_of_rod ([0 1], motion, c);
%! assert (loads.work_phi, [2.5 -1.5], 1e-15); assert (size (loads.work_V), [0 2]);
%! c.force = [];
%! assert (loads_of_rod ([0 1], motion, c).work_phi, [0 0]);
