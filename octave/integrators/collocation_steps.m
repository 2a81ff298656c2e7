## -*- texinfo -*-
## @deftypefn {} {[@var{states}, @var{tangents}] =} collocation_steps (@var{system}, @var{method}, @var{ends}, @var{y}, @
##   @var{m}, @var{tangents}, @var{times}, @var{guess})
## Equal steps of a collocation @var{method} (see @code{collocation}), @var{m} between each two of the @var{ends} (s,
## equally far apart), of a rod on a surface (see @code{surface_rod}) from the state @var{y} (place; velocity; work and
## what is dissipated) on: the @var{states} at @var{times} in there (1-by-k, s), no numbers where Newton's iteration
## did not converge before.
##
## Sixteen steps are solved at once where there are states at the nodes of all of them as a first @var{guess} (see
## @code{guess_through}), or else one after the other; for @var{tangents} see @code{collocation_stages}.
## @end deftypefn

function [states, tangents] = collocation_steps (system, method, ends, y, m, tangents, times, guess)
  states = NaN (rows (y), numel (times));
  n = system.n;
  h = (ends(2) - ends(1))/m;
  last = m*(numel (ends) - 1);
  x = min ((times - ends(1))/h, last);
  guessed = ! isempty (guess) && all (isfinite (guess(:)));
  a = zeros (n, numel (method.points));
  done = 0;
  while (done < last)
    t = ends(1) + h*done;
    count = 1;
    if (guessed)
      count = min (16, last - done);
      nodes = numel (method.nodes);
      [a, starts] = guess_through (method, h, n, guess(:,nodes*done+(1:nodes*count)));
    else
      a *= method.onward.';
      starts = y(1:2*n);
    endif
    [a, starts, stages, tangents, message] = collocation_stages (system, method, t, h, y, a, starts, ...
                                                                 1e-12*system.points(end), tangents);
    if (! isempty (message))
      return;
    endif
    [starts, power] = states_with_work (system, method, t, h, starts, y(2*n+1:end), stages, a);
    inside = x >= done & x <= done + count;
    states(:,inside) = within_step (method.points, h, starts, a, power, x(inside) - done);
    y = starts(:,end);
    done += count;
  endwhile
  states(:,times == ends(end)) = y(:,ones (1, nnz (times == ends(end))));
endfunction

%!function system = oscillator ()   # z'' = -4 z, and the power of a force z_dot
%!  system = struct ("n", 1, "points", 1, "damped", false);
%!  system.size = @(z) max (abs (z)(:));
%!  system.residual = @(t, z, z_dot, a) a + 4*z;
%!  system.power = @(t, z, z_dot, a) [z_dot; 0*z_dot + 3];
%!  system.mass_matrix = @(z) ones (1, 1, columns (z));
%!  system.tangent_stiffness = @(t, z, z_dot, a) 4*ones (1, 1, columns (z));
%!endfunction
%!test # the cosine between and at the ends, by steps in turn and by twenty with a guess
%! method = collocation (4);
%! [ends, times] = deal ([1 1.5 2], [1.01 1.3 1.5 1.72 2]);
%! exact = @(t) [cos(2*(t - 1)); -2*sin(2*(t - 1)); cos(2*(t - 1)) - 1; 3*(t - 1)];
%! in_turn = collocation_steps (oscillator (), method, ends, exact (1), 10, [], times, []);
%! assert (in_turn, exact (times), 1e-9);
%! at_nodes = 1 + ((0:19) + method.nodes)(:).'/20;
%! at_once = collocation_steps (oscillator (), method, ends, exact (1), 10, [], times, 0.9*exact (at_nodes));
%! assert (at_once, in_turn, 1e-11);
%!test # none where there are no numbers
%! system = setfield (oscillator (), "residual", @(t, z, z_dot, a) a + 4*z./(t < 1.5));
%! states = collocation_steps (system, collocation (4), [1 2], [1; 0; 0; 0], 4, [], [1.2 1.7 2], []);
%! assert (isfinite (states(1,:)), logical ([1 0 0]));
