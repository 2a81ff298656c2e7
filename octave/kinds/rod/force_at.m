## -*- texinfo -*-
## @deftypefn {} {@var{F} =} force_at (@var{t}, @var{c})
## The force of a rod at the times @var{t} (1-by-m) and its rate: rows F_x, F_y (N), F_x_dot, F_y_dot (N/s).  The rate
## is what longitudinal modes without inertia need, which stretch as fast as the force grows; without such modes it is
## zero.  It comes from differences within the interval of the constants @var{c} (see @code{rod_constants}), at whose
## ends the force may jump.
## @end deftypefn

function F = force_at (t, c)
  F = [at_times(c.force, t); zeros(2, numel (t))];
  if (c.pulls_followers)
    h = 1e-6*diff (c.interval);
    middle = min (max (t, c.interval(1) + h), c.interval(2) - h);
    F(3:4,:) = (at_times (c.force, middle + h) - at_times (c.force, middle - h))/(2*h);
  endif
endfunction

%!test
%! c = struct ("force", @(t) [sin(t), t >= 1], "pulls_followers", true, "interval", [0, 1 - eps]);
%! assert (force_at ([0.5, 1 - eps], c), [sin([0.5 1]); 0 0; cos([0.5 1]); 0 0], 1e-5);
%! c.pulls_followers = false;
%! assert (force_at (0.5, c), [sin(0.5); 0; 0; 0]);
