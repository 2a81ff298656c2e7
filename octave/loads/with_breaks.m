## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} with_breaks (@var{scene}, @var{loads})
## A @var{scene} of one rod with all breaks of its @var{loads} in its field breaks: those that it states, or has in
## short as moment_breaks, and those that are found, of which the field probed tells (see @code{load_breaks}).
## @end deftypefn

function scene = with_breaks (scene, loads)
  [scene.breaks, scene.probed] = load_breaks (loads, [scene.breaks(:); scene.moment_breaks(:)], scene);
  scene.moment_breaks = [];
endfunction

%!test # both names mean the same
%! scene = struct ("breaks", [3 1], "moment_breaks", 2, "duration", 10, "frames_per_second", 5);
%! scene = with_breaks (scene, load_list ({"moment", @(t) 1*(t >= 6), 1, "a number", [], true}));
%! assert (scene.breaks, [1 2 3 6]); assert (scene.moment_breaks, []); assert (scene.probed.breaks, 6);
%!test # of any kind of scene
%! scene = struct ("rod", struct ("length", 1, "EA", 1, "EI", 1, "rhoA", 1), "duration", 1, "breaks", 0.4);
%! on_plane = setfield (scene, "surface", struct ("name", "plane", "inclination", 0));
%! with_slider = setfield (scene, "joints", {struct("kind", "slider", "stations", 0.5)});
%! for scene = {scene, on_plane, with_slider}
%!   assert (kind_of (scene{1}).check (scene{1}).breaks, 0.4);
%! endfor
