## -*- texinfo -*-
## @deftypefn {} {@var{scene} =} drawn_scene (@var{sort}, @var{number})
## The scenes of `make choices', by their sort and their number in it: 1 is those of octave/scenes/ that choose their
## model, by name; the others are drawn at random from the number, 2 a rod (@code{random_scene}), 3 loaded rods and
## mechanisms (@code{random_loaded_scene}), 4 a curved rod (@code{random_curved_scene}), 5 a rod on a surface
## (@code{random_surface_scene}), and beside these 6 a linkage (@code{random_linkage}).
##
## @example
## make simulate SCENE="tests/choices/drawn_scene.m(3,7)"
## @end example
## @end deftypefn

function scene = drawn_scene (sort, number)
  draw = {@shipped, @random_scene, @random_loaded_scene, @random_curved_scene, @random_surface_scene, ...
          @random_linkage};
  scene = draw{sort} (number);
endfunction

function scene = shipped (number)
  names = scenes_that_choose ();
  scene = load_scene (names{number});
endfunction

%!test
%! sorts = {"", "Random scene 3", "Random loaded scene 3", "Random curved scene 3", "Random surface scene 3", ...
%!          "Random linkage 3"};
%! assert (arrayfun (@(k) drawn_scene (k, 3).title, 2:6, "uniformoutput", false), sorts(2:6));
%!test
%! assert (drawn_scene (1, 2).title, load_scene (scenes_that_choose (){2}).title);
%!function angle = from_outside (file)   # this folder is not on the load path where a scene runs
%!  before = path ();
%!  unwind_protect
%!    rmpath (fileparts (file));
%!    angle = load_scene ([file "(3,2)"]).rotation (0.1)(1);
%!  unwind_protect_cleanup
%!    path (before);
%!  end_unwind_protect
%!endfunction
%!assert (from_outside (which ("drawn_scene")), drawn_scene (3, 2).rotation (0.1)(1))
