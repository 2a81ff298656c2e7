## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} hook ()
## A hook: straight for 0.6 m, then three quarters of a circle of 0.1 m radius; a moment of 0.25 s pulls it up.
## @end deftypefn

function scene = hook ()
  scene.title = "A hook is pulled up and let go";
  scene.rod = struct ("length", 0.6 + 0.15*pi, "width", 0.01, "half_height", 0.003, ...
                      "curvature", @(xi) 10*(xi > 0.6), "curvature_breaks", 0.6);
  scene.model.energy = "uniaxial";
  scene.initial.phi = -pi/2;
  scene.moment = @(t) 8*sin(4*pi*t).^2.*(t < 0.25);
  scene.moment_breaks = 0.25;
  scene.duration = 1.5;
  scene.zoom = 10;
  scene.solver.tolerance = 5e-4;
endfunction

%!test # straight, then three quarters of a circle
%! axis = rod_axis (check_scene (hook ()).rod, 16);
%! assert (axis.weights*axis.kappa.', 1.5*pi, 1e-9);
