## -*- texinfo -*-
## @deftypefn {} {@var{layout} =} frame_layout (@var{drawing})
## Where things are in a frame of @var{drawing} (see @code{draw_pictures}): a struct of @code{width} and @code{height}
## in pixels, of the @code{unit} of all other lengths in pixels (as many as let what is laid out for 1280 by 720 fit
## in, or for 720 by 1280 in a frame that is higher than wide), of the margins @code{scene_right}, @code{scene_bottom}
## and @code{scene_top} of the scene, of @code{strip_width} and @code{strip_height}, and of @code{strip_left},
## @code{strip_bottom}: the distance of the first strip from the frame's right, of the last one from its bottom.  The
## strips stand at the scene's right, or below it in a high frame.
## @end deftypefn

function layout = frame_layout (drawing)
  frame = field_or (drawing, "frame_size", [1280 720])(:).';
  layout.width = frame(1);
  layout.height = frame(2);
  strips = numel (drawing.strips);
  if (frame(2) > frame(1))
    layout.unit = min (frame./[720 1280]);
    high = frame(2)/layout.unit;
    layout.strip_height = min (180, 0.45*high/max (strips, 1) - 30);
    layout.scene_right = 150;
    layout.scene_top = 125;
    layout.scene_bottom = 65;
    if (strips > 0)
      layout.scene_bottom += strips*(layout.strip_height + 30) + 75;
    endif
    layout.strip_left = frame(1)/layout.unit - 95;
  else
    layout.unit = min (frame./[1280 720]);
    high = frame(2)/layout.unit;
    layout.strip_height = 240;
    if (strips > 1)
      layout.strip_height = (high - 210 - 30*(strips - 1))/strips;
    endif
    layout.scene_right = 515;
    layout.scene_top = 65;
    layout.scene_bottom = 65;
    layout.strip_left = 320;
  endif
  layout.strip_bottom = 65;
  layout.strip_width = layout.strip_left - 25;
endfunction

%!function drawing = of_size (frame_size, strips)
%!  drawing = struct ("frame_size", frame_size, "strips", zeros (1, strips));
%!endfunction
%!test # beside the scene, or below it
%! layout = frame_layout (of_size ([640; 360], 3));
%! assert ([layout.unit, layout.scene_right, layout.strip_width, layout.strip_height], [0.5 515 295 150]);
%! layout = frame_layout (of_size ([1080 1920], 3));
%! assert ([layout.unit, layout.strip_width], [1.5 600]);
%! assert (layout.scene_bottom > layout.strip_bottom + 3*(layout.strip_height + 30));
%!test # nothing below the scene
%! assert (frame_layout (of_size ([400 600], 0)).scene_bottom, 65);
%!test # all of it, where a frame has no size of its own, with one strip and with two, and where it is high
%! layout = struct ("width", 1280, "height", 720, "unit", 1, "strip_height", 240, "scene_right", 515, ...
%!                  "scene_top", 65, "scene_bottom", 65, "strip_left", 320, "strip_bottom", 65, "strip_width", 295);
%! assert (frame_layout (struct ("strips", 1)), layout);
%! assert (frame_layout (struct ("strips", [1 1])), setfield (layout, "strip_height", 240));
%! layout = struct ("width", 720, "height", 1280, "unit", 1, "strip_height", 180, "scene_right", 150, ...
%!                  "scene_top", 125, "scene_bottom", 65 + 210 + 75, "strip_left", 625, "strip_bottom", 65, ...
%!                  "strip_width", 600);
%! assert (frame_layout (of_size ([720 1280], 1)), layout);
%! assert (frame_layout (of_size ([720 1280], 4)).strip_height, 0.45*1280/4 - 30);
