## -*- texinfo -*-
## @deftypefn {} {[@var{names}, @var{places}] =} strip_names (@var{label}, @var{names}, @var{room})
## The @var{names} of curves that stand beside the @var{label} of a strip, in their colours: as many as there is room
## for in so many units of @var{room}, with "…" after them where these are not all. @var{places} are where each of them
## ends, in units from the right of the strip.
## @end deftypefn

function [names, places] = strip_names (label, names, room)
  room -= text_width (label);
  reach = cumsum (cellfun (@text_width, names) + 12);
  if (reach(end) > room)
    names = [names(reach + 24 <= room), {"…"}];
  endif
  widths = cellfun (@text_width, names) + 12;
  places = fliplr (cumsum ([0, fliplr(widths(2:end))]));
endfunction

%!test # all, or those that there is room for
%! [names, places] = strip_names ("angles, °", {"a", "b"}, 295);
%! assert (names, {"a", "b"}); assert (places, [text_width("b") + 12, 0]);
%! assert (strip_names ("reactions, N", {"crankshaft", "crank-pin", "rocker-bearing"}, 295), {"crankshaft", "…"});
%! assert (strip_names (repmat ("o", 1, 40), {"a", "b"}, 295), {"…"});
