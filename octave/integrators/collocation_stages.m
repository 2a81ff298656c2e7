## -*- texinfo -*-
## @deftypefn {} {[@var{a}, @var{starts}, @var{stages}, @var{tangents}, @var{message}] =} collocation_stages (@
##   @var{system}, @var{method}, @var{t}, @var{h}, @var{y}, @var{a}, @var{starts}, @var{size}, @var{tangents})
## Accelerations @var{a} (n-by-s a step) at the stages of equal steps of @var{h} (s) in turn of a collocation
## @var{method} (see @code{collocation}), from the time @var{t} and the state @var{y} (place; velocity) of a rod on a
## surface (see @code{surface_rod}) on, by Newton's iteration on all steps at once, until it moves no point by
## @var{size} (m).  It looks from a first guess of @var{a} on, and of @var{starts}, the states where the steps start
## (2n-by-steps), which need not go on from one another (multiple shooting).
##
## @var{starts}: these states, and that at the end; @var{stages}: a cell of places and velocities, as @var{a};
## @var{tangents}: see @code{collocation_tangents}; of one step those of a step before, where they are given and h is
## the same, are taken for as long as they serve, of several those of the first guess, where that is near.
## @var{message}: why there are none, or "".
## @end deftypefn

function [a, starts, stages, tangents, message] = collocation_stages (system, method, t, h, y, a, starts, size, ...
                                                                      tangents = [])
  message = "its Newton iteration did not converge";
  count = columns (starts);
  t += h*((0:count-1) + method.points)(:).';
  change = rate = NaN;
  known = count == 1 && ! isempty (tangents) && tangents.h == h;
  for iteration = 1:12
    stages = stages_of (method, h, starts(:,1:count), a);
    R = system.residual (t, stages{:}, a);
    if (! all (isfinite (R(:))))
      message = "its loads or states are no numbers";
      return;
    elseif (change*rate <= size*(1 - rate) || change <= size/30)
      message = "";
      return;
    elseif (! (change < 10*system.points(end)) && iteration > 1 || (iteration > 3 && rate > 0.9))
      return;
    endif
    near = count > 1 && iteration == 2 && change < 1e-3*system.points(end);
    if (! (near || rate <= 0.2 || (known && iteration == 1)))
      tangents = collocation_tangents (system, method, t, h, stages, a);
    endif
    [a, starts, moved] = newton_step (method, h, tangents, R, y(1:2*rows (a)), a, starts(:,1:count));
    before = change;
    change = system.size (moved);
    rate = change/before;
  endfor
endfunction

function stages = stages_of (method, h, starts, a)
  n = rows (a);
  count = columns (starts);
  z = starts(1:n,:);
  v = starts(n+1:end,:);
  of = kron (1:count, ones (size (method.points.')));
  each = @(weights) kron (eye (count), weights.');
  stages = {z(:,of) + h*v(:,of).*repmat(method.points.', 1, count) + h^2*a*each(method.AA), ...
            v(:,of) + h*a*each(method.A)};
endfunction

## better accelerations and states where the steps start, with the end; and by how much places moved
function [a, starts, moved] = newton_step (method, h, tangents, R, reached, a, starts)
  [n, columns] = size (R);
  s = numel (method.points);
  moved = [];
  for i = 1:columns/s
    stages = s*(i - 1) + (1:s);
    change = reached - starts(:,i);
    excess = R(:,stages);
    if (any (change))
      excess += follow (tangents, stages, change(1:n) + h*change(n+1:end).*method.points.', change(n+1:end));
    endif
    of_step = tangents.factors(i);
    step = -reshape (of_step.upper \ (of_step.lower \ excess(:)(of_step.order)), n, s);
    a(:,stages) += step;
    starts(:,i) = reached;
    reached = [reached(1:n) + h*reached(n+1:end) + h^2*a(:,stages)*method.second_weights.'
               reached(n+1:end) + h*a(:,stages)*method.weights.'];
    moved = [moved, change(1:n), h^2*step];
  endfor
  starts(:,end+1) = reached;
endfunction

## forces that follow changes of places and of the velocity
function forces = follow (tangents, pages, places, velocity)
  for k = 1:numel (pages)
    forces(:,k) = tangents.K(:,:,pages(k))*places(:,k) + tangents.C(:,:,pages(k))*velocity;
  endfor
endfunction

%!function system = oscillators ()   # z'' = -4 z, and z'' = -4 sin z
%!  system.points = 1;
%!  system.damped = false;
%!  system.size = @(z) max (abs (z)(:));
%!  system.residual = @(t, z, z_dot, a) a + 4*[z(1,:); sin(z(2,:))];
%!  system.mass_matrix = @(z) repmat (eye (2), [1 1 columns(z)]);
%!  K = @(z) [ones(1, columns (z)); 0*z(1,:); 0*z(1,:); cos(z(2,:))];
%!  system.tangent_stiffness = @(t, z, z_dot, a) 4*reshape (K (z), 2, 2, []);
%!endfunction
%!test # the cosine, and the polynomial's accelerations where its places are
%! [a, ~, stages, tangents, message] = collocation_stages (oscillators (), collocation (4), 0, 0.1, [1; 1; 0; 0], ...
%!                                                      zeros (2, 4), [1; 1; 0; 0], 1e-12);
%! assert (message, ""); assert (size (tangents.K), [2 2 4]);
%! assert (a(1,:), -4*cos (0.2*collocation (4).points.'), 1e-7);
%! assert (a(2,:), -4*sin (stages{1}(2,:)), 1e-11);
%!test # why there are none
%! from = {collocation(4), 0, 0.1, [1; 1; 0; 0], zeros(2, 4), [1; 1; 0; 0], 1e-12};
%! system = setfield (oscillators (), "residual", @(t, z, z_dot, a) NaN*a);
%! [~, ~, ~, ~, message] = collocation_stages (system, from{:});
%! assert (message, "its loads or states are no numbers");
%! system = setfield (oscillators (), "tangent_stiffness", @(t, z, varargin) -2e3*ones (2, 2, columns (z)));
%! [~, ~, ~, ~, message] = collocation_stages (system, from{:});
%! assert (message, "its Newton iteration did not converge");
%!test # three steps at once are one after the other
%! method = collocation (4);
%! [system, y] = deal (oscillators (), [1; 1; 0; 0.5]);
%! [a, starts] = collocation_stages (system, method, 0, 0.3, y, zeros (2, 12), [1; 1; 0; 0.5]*[1 0.9 0.8], 1e-13);
%! for i = 1:3
%!   assert (starts(:,i), y, 1e-12);
%!   [one, ends] = collocation_stages (system, method, 0.3*(i - 1), 0.3, y, zeros (2, 4), y, 1e-13);
%!   assert (a(:,4*i-3:4*i), one, 1e-10);
%!   y = ends(:,end);
%! endfor
%! assert (starts(:,4), y, 1e-12); assert (y([1 3]), [cos(1.8); -2*sin(1.8)], 1e-8);
