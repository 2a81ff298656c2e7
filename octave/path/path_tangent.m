## -*- texinfo -*-
## @deftypefn {} {@var{tangent} =} path_tangent (@var{point}, @var{ahead})
## The direction [dq; dfactor] (n+1-by-1) of a path at a @var{point} of it (see @code{path_point}), of length 1 in its
## metric, to the side of @var{ahead} (likewise).
## @end deftypefn

function tangent = path_tangent (point, ahead)
  tangent = bordered (point.linear, point.load, point.metric*ahead, zeros (columns (point.linear.basis), 1), 1);
  tangent /= sqrt (tangent.'*point.metric*tangent);
endfunction

%!test # of a pendulum that hangs and is drawn aside: its angle grows by 1/(m g/2) a newton
%! path = pulled_pendulum ();
%! point = path_point (path, [-pi/2; 0; 0; 0], zeros (2, 1), [0; 0; 0; 1]);
%! tangent = path_tangent (point, [0; 0; 0; 1]);
%! assert (tangent(1)/tangent(4), 1/(9.81/2), 1e-8); assert (tangent.'*point.metric*tangent, 1, 1e-12);
%! assert (path_tangent (point, [0; 0; 0; -1]), -tangent, 1e-12);
