## -*- texinfo -*-
## @deftypefn {} {@var{tolerance} =} tolerance_in_metres (@var{scene})
## The scene's tolerance as a length: "pixel" is half a pixel of a drawn frame at the scene's zoom: 720 pixels
## of a frame of 1280 by 720 for 2.5 lengths of the rod.
## @end deftypefn

function tolerance = tolerance_in_metres (scene)
  tolerance = scene.solver.tolerance;
  if (ischar (tolerance))
    pixels = min (scene.frame_size.*[720/1280, 1]);
    tolerance = 0.5*2.5*scene.rod.length/pixels/max (scene.zoom, 1);
  endif
endfunction

%!test # half a pixel of 2.5 m in 720, at zoom 300
%! scene = check_scene (setfield (paper (), "solver", "tolerance", "pixel"));
%! assert (tolerance_in_metres (scene), 0.5*2.5/720/300, 1e-12);
%! scene.frame_size = [2560 1440];
%! assert (tolerance_in_metres (scene), 0.25*2.5/720/300, 1e-12);
