## -*- texinfo -*-
## @deftypefn {} {@var{notes} =} stress_notes (@var{rods}, @var{bodies})
## Of the bodies that are drawn without a stress, those that may have one: a cellstr that says which, and why.
## @var{rods} (struct array) are the fields of the rods of the @var{bodies} (see @code{draw_pictures}).
## @end deftypefn

function notes = stress_notes (rods, bodies)
  notes = {};
  for k = 1:numel (bodies)
    reason = stress_unknown (rods(k));
    if (! isempty (reason) && isempty (bodies(k).stress) && ! isequal (bodies(k).x, bodies(k).rest_x))
      of = "";
      if (numel (bodies) > 1)
        of = sprintf (" of body %d", k);
      endif
      notes{end+1} = sprintf ("no stress%s is drawn: %s", of, reason);
    endif
  endfor
endfunction

%!test # a bent rod without a width, a rigid one, and one whose stress is drawn
%! rod = struct ("width", {[], [], 1}, "half_height", 1, "EA", []);
%! body = struct ("stress", {[], [], 1}, "x", {1, 2, 3}, "rest_x", {1.1, 2, 3.1});
%! assert (stress_notes (rod, body), ...
%!         {"no stress of body 1 is drawn: rod.width and rod.half_height are not both stated"});
