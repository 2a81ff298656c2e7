## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} saddle ()
## A rod lies across a saddle, a little aside and turned: it slides off, and the surface would have to
## hold what bends down.
## @end deftypefn

function scene = saddle ()
  scene.title = "A rod on a saddle";
  scene.surface = struct ("name", "saddle", "rise", 1.2, "fall", 0.6);
  scene.rod = struct ("length", 0.7, "EA", 5e3, "EI", 0.05, "EI_normal", 0.005, "GJ", 0.005, "rhoA", 0.2, ...
                      "half_height", 0.008);
  scene.initial = struct ("point", [-0.3 -0.05], "angle", 0.2);
  scene.duration = 1;
  scene.view = struct ("elevation", 40, "azimuth", -60);
endfunction

%!test # the surface rises one way and falls the other, the rod lies beside its middle and slides down
%! scene = saddle ();
%! surface = surface_functions (scene.surface);
%! height = @(alpha_1, alpha_2) nthargout (3, surface.position, struct ("alpha1", alpha_1, "alpha2", alpha_2));
%! assert (height (0.3, 0) > 0 && height (0, 0.3) < 0);
%! [scene.duration, scene.model.modes] = deal (0.04, [4 4]);
%! history = driver (scene, "output", "").history;
%! assert (hypot (history.x(51,1), history.y(51,1)) > 0.01);
%! assert (history.Z(end) < history.Z(1));
