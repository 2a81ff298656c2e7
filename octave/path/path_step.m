## -*- texinfo -*-
## @deftypefn {} {[@var{next}, @var{step}] =} path_step (@var{path}, @var{point}, @var{step})
## The @var{next} point of a @var{path} (see @code{path_point}), with its tangent, a @var{step} (m, see there) along
## its arc after a @var{point} (Riks, Int. J. Solids Struct. 15, 1979; on a plane across the tangent, from a place
## ahead that bends as the path did), and the step that is to be tried after it: longer where Newton's iteration took
## less than six sweeps (Crisfield, Computers and Structures 13, 1981). A step that fails, that turns the tangent
## by more than 37 degrees, or that ends on another path, is halved; @var{next} is empty where none is left.
##
## The whole range of factors is as long as the longest rod, and no step longer than a tenth of it.
## @end deftypefn

function [next, step] = path_step (path, point, step)
  step = min (step, path.size/10);
  ahead = point.metric*point.tangent;
  while (step > 1e-8*path.size)
    [next, sweeps] = path_point (path, point.x + step*point.tangent + step^2/2*point.bend, point.lambda, ahead);
    if (! isempty (next))
      next.tangent = path_tangent (next, point.tangent);
      next.bend = (next.tangent - point.tangent)/step;
      if (ahead.'*next.tangent >= 0.8 && leads_there (path, point, next))
        step *= min (max (6/sweeps, 1/2), 2);
        return;
      endif
    endif
    step /= 2;
  endwhile
  next = [];
endfunction

## a path turns unstable at a limit point only if its factor turns round there (Allgower and Georg, 1990, section 8.1)
function yes = leads_there (path, point, next)
  limits = 0;
  if (next.unstable != point.unstable)
    limits = sum (cellfun (@(event) strcmp (event.event, "limit point"), path_events (path, point, next)));
  endif
  yes = mod (limits, 2) == (next.tangent(end)*point.tangent(end) < 0);
endfunction

%!test # half a hundredth of its 1 m along a column that leans; the next step is longer, but a tenth at most
%! path = sprung_column (0.1);
%! point = path_point (path, [0.1; 0], zeros (0, 1), [0; 1]);
%! point.tangent = path_tangent (point, [0; 1]);
%! [next, step] = path_step (path, point, 0.005);
%! assert (next.x(1) - 0.1, next.x(2)*sin (next.x(1)), 1e-12);
%! dx = next.x - point.x;
%! assert (dx.'*point.metric*dx, 0.005^2, 1e-8); assert (step > 0.005);
%! [far, step] = path_step (path, point, 3);
%! assert (norm (chol (point.metric)*(far.x - point.x)), 0.1, 1e-3); assert (step, 0.2, 1e-12);  # of three sweeps
%!test # where forces are no numbers there is no way on
%! path = sprung_column ();
%! path.balance.residual = @(factor, q, v, lambda) factor.*sin (q) - q + (factor > 0)*NaN;
%! point = path_point (sprung_column (), [0; 0], zeros (0, 1), [0; 1]);
%! point.tangent = [0; 1];
%! assert (path_step (path, point, 0.1), []);
%!test # a column that leans hardly goes on along the path that bends, not to the upright one that is not stable
%! path = sprung_column (0.001);
%! point = path_point (path, [0.01; 0], zeros (0, 1), [1; 0]);
%! point.tangent = path_tangent (point, [1; 0]);
%! next = path_step (path, point, 0.1);
%! assert (next.x(1) > point.x(1)); assert (next.unstable, 0);
