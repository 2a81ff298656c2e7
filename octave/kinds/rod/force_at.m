## -*- texinfo -*-
## @deftypefn {} {@var{F} =} force_at (@var{t}, @var{c})
## The force of a rod at the times @var{t} (1-by-m) and its rate: rows F_x, F_y (N), F_x_dot, F_y_dot (N/s).  The rate
## is what longitudinal modes without inertia need, which stretch as fast as the force grows; without such modes it is
## zero.  It comes from differences within an interval between two of the ends in the constants @var{c} (see
## @code{rod_constants}), where the force may jump.
## @end deftypefn

function F = force_at (t, c)
  F = [c.force(t); zeros(2, numel (t))];
  if (c.pulls_followers)
    k = lookup (c.ends, t, "lr");
    h = 1e-6*diff (c.ends)(k);
    middle = min (max (t, c.ends(k) + 2*h), c.ends(k+1) - 2*h);
    F(3:4,:) = (c.force (middle + h) - c.force (middle - h))./(2*h);
  endif
endfunction

%!test
%! c = struct ("force", @(t) [sin(t); t >= 1], "pulls_followers", true, "ends", [0 1 3]);
%! assert (force_at ([0.5, 1 - eps, 1, 3], c), [sin([0.5 1 1 3]); 0 0 1 1; cos([0.5 1 1 3]); 0 0 0 0], 1e-5);
%! c.pulls_followers = false;
%! assert (force_at (0.5, c), [sin(0.5); 0; 0; 0]);
