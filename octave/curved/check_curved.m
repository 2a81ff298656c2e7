## -*- texinfo -*-
## @deftypefn {} {} check_curved (@var{scene})
## An error where a scene's rod.curvature has values that are no numbers, or where the scene asks for what a curved rod does
## not take.
## @end deftypefn

function check_curved (scene)
  refused = {"rotation", ! isempty(scene.rotation); "force", ! isempty(scene.force); "tip_mass", scene.tip_mass > 0
             "model.stiffening = \"foreshortening\"", strcmp(scene.model.stiffening, "foreshortening")
             "model.axial = \"quasistatic\"", strcmp(scene.model.axial, "quasistatic")};
  for row = refused.'
    if (row{2})
      scene_error ("%s and rod.curvature are both given: a curved rod takes a moment at O and its weight", row{1});
    endif
  endfor
  breaks = scene.rod.curvature_breaks;
  if (any (breaks < 0 | breaks > scene.rod.length))
    scene_error ("rod.curvature_breaks are [%s]: they take stations from 0 to %g m", num2str (breaks(:).'), scene.rod.length);
  endif
  axis = rod_axis (scene.rod, 16);
  thick = [scene.rod.half_height, 0](1)*max (abs (axis.kappa));
  if (thick >= 1)
    scene_error ("rod.curvature reaches %.3g 1/m: with a half_height of %g m it takes less than %.3g", max (abs (axis.kappa)), ...
                 scene.rod.half_height, 1/scene.rod.half_height);
  endif
endfunction

%!error <rod.curvature reaches 100 1/m: with a half_height of 0.02 m it takes less than 50>
%! check_scene (struct ("rod", struct ("length", 0.1, "width", 0.02, "half_height", 0.02, "curvature", 100), "duration", 1));
%!error <force and rod.curvature are both given>
%! check_scene (struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.02, "curvature", 1), "duration", 1, "force", @(t) [0 1]));
%!error <rod.curvature gives 1 values for \d+ stations>
%! check_scene (struct ("rod", struct ("length", 1, "width", 0.02, "half_height", 0.02, "curvature", @(xi) 1), "duration", 1));
