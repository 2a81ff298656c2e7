## -*- texinfo -*-
## @deftypefn {} {@var{tolerance} =} tolerance_in_metres (@var{scene})
## The scene's tolerance as a length: "pixel" is half a pixel of a drawn frame, 720 pixels for 2.5 lengths of the rod, at
## the scene's zoom.
## @end deftypefn

function tolerance = tolerance_in_metres (scene)
  tolerance = scene.solver.tolerance;
  if (ischar (tolerance))
    tolerance = 0.5*2.5*scene.rod.length/720/max (scene.zoom, 1);
  endif
endfunction

%!test # half a pixel of 2.5 m in 720, at zoom 300
%! scene = check_scene (setfield (paper (), "solver", "tolerance", "pixel"));
%! assert (tolerance_in_metres (scene), 0.5*2.5/720/300, 1e-12);
