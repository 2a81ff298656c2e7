## -*- texinfo -*-
## @deftypefn {} {@var{offset} =} constraint_offset (@var{kind}, @var{k})
## What constraints of one @var{kind} (see @code{list_constraints}) take beside markers and values in @var{k} states: a
## cell of the angles (rad; rows-by-k) of a slider's line against the second tangent, else an empty one.
## @end deftypefn

function offset = constraint_offset (kind, k)
  offset = {};
  if (kind.takes_offset)
    offset = {kind.offset.*ones(1, k)};
  endif
endfunction

%!assert (constraint_offset (struct ("takes_offset", true, "offset", [3; 4]), 2), {[3 3; 4 4]})
%!assert (constraint_offset (struct ("takes_offset", false, "offset", 3), 2), {})
