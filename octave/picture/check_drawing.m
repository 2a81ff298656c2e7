## -*- texinfo -*-
## @deftypefn {} {} check_drawing (@var{drawing})
## It is an error, which names the field, when a field of @var{drawing} (see @code{draw_pictures}) that changes with
## time has not a column for each frame, or holds a value that is not finite.
## @end deftypefn

function check_drawing (drawing)
  frames = numel (drawing.time);
  check_fields (struct ("x", drawing.hinges.x, "y", drawing.hinges.y), "hinges.", frames);
  check_fields (struct ("time", drawing.time, "moment", drawing.moment), "", frames);
  check_fields (rmfield (field_or (drawing, "springs", struct ("shape", [])), "shape"), "springs.", frames);
  for acting = {"forces", "moments"}
    check_fields (field_or (drawing, acting{1}, struct ()), [acting{1} "."], frames);
  endfor
  for i = 1:numel (drawing.bodies)
    body = rmfield (drawing.bodies(i), "half_height");
    if (isempty (body.stress))
      body = rmfield (body, "stress");
    endif
    check_fields (body, sprintf ("bodies(%d).", i), frames);
  endfor
  times = struct ("strips", frames, "panels", numel (panel_time (drawing)));
  for kind = {"strips", "panels"}
    for i = 1:numel (drawing.(kind{1}))
      check_fields (struct ("values", drawing.(kind{1})(i).values), sprintf ("%s(%d).", kind{1}, i), times.(kind{1}));
    endfor
  endfor
endfunction

function check_fields (fields, prefix, frames)
  for [value, name] = fields
    if (columns (value) != frames || ! all (isfinite (value(:))))
      error ("draw_pictures: %s%s must be finite, with %d frames", prefix, name, frames);
    endif
  endfor
endfunction

%!test # no stress is fine, and no panels
%! drawing = sample_drawing (2);
%! drawing.panels = [];
%! drawing.bodies(1).stress = [];
%! check_drawing (drawing);
%!error <draw_pictures: springs.to_x must be finite, with 3 frames>
%! drawing = sample_drawing (3);
%! drawing.springs = struct ("x", ones (1, 3), "y", ones (1, 3), "to_x", NaN (1, 3), "to_y", ones (1, 3));
%! drawing.springs.shape = {"coil"};
%! check_drawing (drawing);
%!error <draw_pictures: moment must be finite, with 3 frames>
%! drawing = sample_drawing (3);
%! drawing.moment = 0;
%! check_drawing (drawing);
%!error <draw_pictures: panels\(4\).values must be finite, with 3 frames>
%! drawing = sample_drawing (3);
%! drawing.panels(4).values(2) = Inf;
%! check_drawing (drawing);
