## -*- texinfo -*-
## @deftypefn {} {@var{mechanism} =} seen_whole (@var{mechanism})
## The @var{mechanism} with markers (see @code{list_markers}) whose points and tangents are all seen, by a joint or
## not.
## @end deftypefn

function mechanism = seen_whole (mechanism)
  for g = 1:numel (mechanism.markers)
    mechanism.markers(g).sees_point = mechanism.markers(g).sees_tangent = true;
  endfor
endfunction

%!test
%! whole = seen_whole (struct ("markers", struct ("sees_point", {true, false}, "sees_tangent", {false, false})));
%! assert ([whole.markers.sees_point, whole.markers.sees_tangent]);
