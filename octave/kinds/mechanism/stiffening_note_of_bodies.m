## -*- texinfo -*-
## @deftypefn {} {@var{note} =} stiffening_note_of_bodies (@var{scene})
## What @code{stiffening_note} has to say of a checked scene's bodies: of those that are straight and state their
## modes.
## @end deftypefn

function note = stiffening_note_of_bodies (scene)
  bending = zeros (1, numel (scene.bodies));
  for k = 1:numel (scene.bodies)
    body = scene.bodies(k);
    if (isnumeric (body.model.modes) && isempty (body.rod.curvature))
      bending(k) = body.model.modes(2);
    endif
  endfor
  note = stiffening_note ([scene.bodies.model], bending);
endfunction

%!test
%! scene = check_mechanism (chain (2));
%! assert (! isempty (stiffening_note_of_bodies (scene)));
%! for k = 1:2
%!   scene.bodies(k).model.modes = "auto";
%! endfor
%! assert (stiffening_note_of_bodies (scene), "");
