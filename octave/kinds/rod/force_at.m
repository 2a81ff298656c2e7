## -*- texinfo -*-
## @deftypefn {} {@var{force} =} force_at (@var{t}, @var{c})
## The force of a rod at the times @var{t} (1-by-m) and its rate: a struct of force_x, force_y (1-by-m, N),
## force_x_dot, force_y_dot (N/s), zeros where there is no force.  The rate is what longitudinal modes without inertia
## need, which stretch as fast as the force grows; without such modes it is zero.  It comes from differences within an
## interval between two of the ends in the constants @var{c} (see @code{rod_constants}), where the force may jump.
## @end deftypefn

function force = force_at (t, c)
  F = zeros (4, numel (t));
  if (! isempty (c.force))
    F(1:2,:) = c.force (t);
  endif
  if (c.pulls_followers)
    k = lookup (c.ends, t, "lr");
    h = 1e-6*diff (c.ends)(k);
    middle = min (max (t, c.ends(k) + 2*h), c.ends(k+1) - 2*h);
    F(3:4,:) = (c.force (middle + h) - c.force (middle - h))./(2*h);
  endif
  force = struct ("force_x", F(1,:), "force_y", F(2,:), "force_x_dot", F(3,:), "force_y_dot", F(4,:));
endfunction

%!test
%! c = struct ("force", @(t) [sin(t); t >= 1], "pulls_followers", true, "ends", [0 1 3]);
%! F = @(t, c) cell2mat (struct2cell (force_at (t, c)));
%! assert (F ([0.5, 1 - eps, 1, 3], c), [sin([0.5 1 1 3]); 0 0 1 1; cos([0.5 1 1 3]); 0 0 0 0], 1e-5);
%! c.pulls_followers = false;
%! assert (F (0.5, c), [sin(0.5); 0; 0; 0]);
%! c.force = [];
%! assert (F ([1 2], c), zeros (4, 2));
