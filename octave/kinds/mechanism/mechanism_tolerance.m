## -*- texinfo -*-
## @deftypefn {} {@var{tolerance} =} mechanism_tolerance (@var{scene})
## The scene's tolerance as a length: "pixel" is half a pixel of a frame, 720 pixels for 2.5 times the longest rod, at
## the scene's zoom, as for one rod.
## @end deftypefn

function tolerance = mechanism_tolerance (scene)
  longest.length = max (arrayfun (@(body) body.rod.length, scene.bodies));
  scene.rod = longest;
  tolerance = tolerance_in_metres (scene);
endfunction

%!test
%! [~, ~, scene] = sample_mechanism ([0 1]);
%! assert (mechanism_tolerance (scene), 0.5*2.5*0.5/720, 1e-12);
