## -*- texinfo -*-
## @deftypefn {} {@var{metres} =} plane_pixel (@var{scene}, @var{length})
## A drawn pixel of a frame that shows 2.5 times this @var{length} (m), that of the longest rod, in 720 pixels of 1280
## by 720, at the scene's zoom.
## @end deftypefn

function metres = plane_pixel (scene, length)
  pixels = min (scene.frame_size.*[720/1280, 1]);
  metres = 2.5*length/pixels/max (scene.zoom, 1);
endfunction

%!test # 2.5 m in 720, at zoom 300
%! scene = struct ("frame_size", [1280 720], "zoom", 300);
%! assert (plane_pixel (scene, 1), 2.5/720/300, 1e-12);
%! assert (plane_pixel (setfield (scene, "frame_size", [2560 1440]), 1), 1.25/720/300, 1e-12);
%! assert (plane_pixel (setfield (scene, "zoom", 1), 1), 2.5/720, 1e-12);
%! assert (plane_pixel (setfield (scene, "zoom", 0), 1), 2.5/720, 1e-12);
