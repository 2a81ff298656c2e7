## -*- texinfo -*-
## @deftypefn {} {[@var{a}, @var{stages}, @var{tangents}, @var{message}] =} collocation_stages (@var{system}, @
##   @var{method}, @var{t}, @var{h}, @var{z}, @var{z_dot}, @var{a}, @var{size}, @var{tangents})
## Accelerations @var{a} (n-by-s) at the stages of a collocation @var{method} (see @code{collocation}) in a step of
## @var{h} (s) from the time @var{t}, place @var{z} and velocity @var{z_dot} of a rod on a surface (see
## @code{surface_rod}) on, by Newton's iteration from a first guess of @var{a}, until a step of it moves no point by
## @var{size} (m).
##
## @var{stages}: a cell of places and velocities; @var{tangents}: a struct of M, C and K (n-by-n-by-s), h, and the factors
## of Newton's matrix; those of a step before, where they are given and h is the same, are taken for as long as they
## serve.  @var{message}: why there are none, or "".
##
## Every stage has its own stiffness in Newton's matrix: what stretches turns with the rod within a step, and is stiff.
## @end deftypefn

function [a, stages, tangents, message] = collocation_stages (system, method, t, h, z, z_dot, a, size, tangents = [])
  message = "its Newton iteration did not converge";
  t += h*method.points.';
  change = rate = NaN;
  known = ! isempty (tangents) && tangents.h == h;
  for iteration = 1:12
    stages = {z + h*z_dot*method.points.' + h^2*a*method.AA.', z_dot + h*a*method.A.'};
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
    if (! (rate <= 0.2 || (known && iteration == 1)))
      tangents = tangents_of (system, method, t, h, stages, a);
    endif
    step = -reshape (tangents.upper \ (tangents.lower \ R(:)(tangents.order)), rows (a), []);
    a += step;
    before = change;
    change = system.size (h^2*step);
    rate = change/before;
  endfor
endfunction

function tangents = tangents_of (system, method, t, h, stages, a)
  tangents.h = h;
  tangents.K = system.tangent_stiffness (t, stages{:}, a);
  tangents.M = system.mass_matrix (stages{1});
  tangents.C = 0*tangents.K;
  if (system.damped)
    tangents.C = system.tangent_damping (t, stages{:}, a);
  endif
  matrix = newton_matrix (method, h, tangents, system.damped);
  [tangents.lower, tangents.upper, tangents.order] = lu (matrix, "vector");
endfunction

function matrix = newton_matrix (method, h, tangents, damped)
  [n, ~, s] = size (tangents.K);
  for i = 1:s
    own = (i - 1)*n + (1:n);
    matrix(own,:) = kron (h^2*method.AA(i,:), tangents.K(:,:,i));
    if (damped)
      matrix(own,:) += kron (h*method.A(i,:), tangents.C(:,:,i));
    endif
    matrix(own,own) += tangents.M(:,:,i);
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
%! [a, stages, tangents, message] = collocation_stages (oscillators (), collocation (4), 0, 0.1, [1; 1], [0; 0], ...
%!                                                      zeros (2, 4), 1e-12);
%! assert (message, ""); assert (size (tangents.K), [2 2 4]);
%! assert (a(1,:), -4*cos (0.2*collocation (4).points.'), 1e-7);
%! assert (a(2,:), -4*sin (stages{1}(2,:)), 1e-11);
%!test # why there are none
%! system = setfield (oscillators (), "residual", @(t, z, z_dot, a) NaN*a);
%! [~, ~, ~, message] = collocation_stages (system, collocation (4), 0, 0.1, [1; 1], [0; 0], zeros (2, 4), 1e-12);
%! assert (message, "its loads or states are no numbers");
%! system = setfield (oscillators (), "tangent_stiffness", @(t, z, varargin) -2e3*ones (2, 2, columns (z)));
%! [~, ~, ~, message] = collocation_stages (system, collocation (4), 0, 0.1, [1; 1], [0; 0], zeros (2, 4), 1e-12);
%! assert (message, "its Newton iteration did not converge");
