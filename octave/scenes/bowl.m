## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} bowl ()
## A rod is pushed along the wall of a spherical bowl and swings about its lowest point.
## @end deftypefn

function scene = bowl ()
  scene.title = "A rod circles in a bowl";
  scene.surface = struct ("name", "sphere", "radius", 0.5);
  scene.rod = struct ("length", 0.5, "EA", 2e3, "EI", 0.05, "EI_normal", 0.01, "rhoA", 0.2, "half_height", 0.008);
  scene.initial = struct ("point", [0.3 -0.2], "angle", 1.4);
  scene.initial.velocity = @(xi, alpha) 3.5*[-alpha(2,:); alpha(1,:)];
  scene.duration = 1.5;
  scene.view = struct ("elevation", 45, "azimuth", -40, "turning", 20);
endfunction

%!test # it begins within the bowl, and is pushed along its wall: across the lines from the lowest point
%! scene = bowl ();
%! at = [0.3 -0.2; -0.2 0.1].';
%! velocity = scene.initial.velocity ([0 0], at);
%! assert (dot (velocity, at), [0 0], 1e-12);
%! assert (norm (velocity(:,1)) > 1);
%! assert (scene.rod.length < pi/2*scene.surface.radius);
