## -*- texinfo -*-
## @deftypefn {} {} check_drawing (@var{drawing})
## It is an error, which names the field, when a field of @var{drawing} (see @code{draw_pictures}) that changes with
## time has not a column for each frame, or holds a value that is not finite.
## @end deftypefn

function check_drawing (drawing)
  frames = numel (drawing.time);
  check_fields (rmfield (drawing.history, {"V_names", "torque"}), "history.", frames);
  check_fields (drawing.hinges, "hinges.", frames);
  check_fields (struct ("time", drawing.time, "moment", drawing.moment), "", frames);
  for i = 1:numel (drawing.bodies)
    body = rmfield (drawing.bodies(i), "half_height");
    if (isempty (body.stress))
      body = rmfield (body, "stress");
    endif
    check_fields (body, sprintf ("bodies(%d).", i), frames);
  endfor
endfunction

function check_fields (fields, prefix, frames)
  for [value, name] = fields
    if (columns (value) != frames || ! all (isfinite (value(:))))
      error ("draw_pictures: %s%s must be finite, with %d frames", prefix, name, frames);
    endif
  endfor
endfunction

%!test # no modes and no stress are fine
%! drawing = sample_drawing (2);
%! drawing.history.V = zeros (0, 2);
%! drawing.bodies(1).stress = [];
%! check_drawing (drawing);
%!error <draw_pictures: moment must be finite, with 3 frames>
%! drawing = sample_drawing (3);
%! drawing.moment = 0;
%! check_drawing (drawing);
%!error <draw_pictures: history.U must be finite, with 3 frames>
%! drawing = sample_drawing (3);
%! drawing.history.U(2) = Inf;
%! check_drawing (drawing);
