## -*- texinfo -*-
## @deftypefn {} {} check_curvature (@var{rod}, @var{of})
## An error where the curvature of a scene's @var{rod} has values that are no numbers, or are too large for its
## half_height; @var{of} stands before the name of the field.
## @end deftypefn

function check_curvature (rod, of)
  breaks = rod.curvature_breaks;
  if (any (breaks < 0 | breaks > rod.length))
    scene_error ("%srod.curvature_breaks are [%s]: they take stations from 0 to %g m", of, ...
                 num2str (breaks(:).'), rod.length);
  endif
  largest = max (abs (rod_axis (rod, 16).kappa));
  if (! isempty (rod.half_height) && rod.half_height*largest >= 1)
    scene_error ("%srod.curvature reaches %.3g 1/m: with a half_height of %g m it takes less than %.3g", ...
                 of, largest, rod.half_height, 1/rod.half_height);
  endif
endfunction

%!function check_with (curvature)
%!  check_scene (struct ("rod", struct ("length", 0.1, "width", 0.02, "half_height", 0.02, "curvature", curvature), ...
%!                       "duration", 1));
%!endfunction
%!error <rod.curvature reaches 100 1/m: with a half_height of 0.02 m it takes less than 50> check_with (100)
%!error <rod.curvature gives 1 values for \d+ stations> check_with (@(xi) 1)
%!error <rod.curvature_breaks are \[3\]: they take stations from 0 to 1 m>
%! check_curvature (struct ("length", 1, "half_height", [], "curvature", 1, "curvature_breaks", 3), "");
