## -*- texinfo -*-
## @deftypefn {} {@var{cubic} =} path_cubic (@var{point}, @var{next})
## The cubic with the places and tangents of a path at a @var{point} and at the @var{next} one (see @code{path_point}):
## x = @var{cubic}*[share^3; share^2; share; 1], n+1-by-4, for shares from 0 to 1.
## @end deftypefn

function cubic = path_cubic (point, next)
  chord = next.x - point.x;
  arc = sqrt (chord.'*point.metric*chord);
  start = arc*point.tangent;
  ends = arc*next.tangent;
  cubic = [start + ends - 2*chord, 3*chord - 2*start - ends, start, point.x];
endfunction

%!test # places and tangents at both ends
%! point = struct ("x", [1; 2], "tangent", [0; 1], "metric", eye (2));
%! next = struct ("x", [4; 6], "tangent", [1; 0]);
%! cubic = path_cubic (point, next);
%! assert (cubic*[0 0 0 1; 1 1 1 1].', [1 4; 2 6], 1e-14); assert (cubic*[0 0 1 0; 3 2 1 0].', [0 5; 5 0], 1e-14);
