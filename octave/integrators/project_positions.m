## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{residual}] =} project_positions (@var{system}, @var{t}, @var{q}, @var{seconds})
## The coordinates near @var{q} (n-by-1) that meet the constraints at the time @var{t} (s), by Newton's iteration with
## the shortest steps in the mass metric, and the largest @var{residual} left.  Stiffness times @var{seconds}^2 (0) is
## added to the mass: with a second, rods are rather moved than bent.
## @end deftypefn

function [q, residual] = project_positions (system, t, q, seconds = 0)
  residual = Inf;
  metric = 0;
  if (seconds > 0)
    metric = seconds^2*system.stiffness;
  endif
  for iteration = 1:50
    at = system.at (t, q, 0*q);
    [mass, jacobian] = system.matrices (at);
    last = residual;
    residual = max ([abs(at.constraints.residual); 0]);
    if (residual < 1e-14 || (residual < 1e-11 && residual > last/4))
      return;
    endif
    step = saddle_solve (system, 0, mass + metric, jacobian, 0*q, -at.constraints.residual);
    largest = max (abs (step)./system.q_scale);
    q += step*min (1, 0.5/largest);  # half a metre, half a radian on a rod of a metre
  endfor
endfunction

%!test # onto a circle, the nearest way
%! system = struct ("q_scale", [1; 1]);
%! system.at = @(t, q, v) struct ("constraints", struct ("residual", q.'*q - 1), "q", q);
%! system.matrices = @(at) deal (speye (2), sparse (2*at.q.'));
%! assert (project_positions (system, 0, [3; 4]), [0.6; 0.8], 1e-10);
%!function at = remembered (seen, q)
%!  seen(seen.Count + 1) = q;
%!  at = struct ("constraints", struct ("residual", q.'*q - 1), "q", q);
%!endfunction
%!test # by half a metre at most in a step, and quadratically at the end
%! seen = containers.Map ("KeyType", "double", "ValueType", "any");
%! system = struct ("q_scale", [1; 1], "at", @(t, q, v) remembered (seen, q));
%! system.matrices = @(at) deal (speye (2), sparse (2*at.q.'));
%! [q, residual] = project_positions (system, 0, [3; 4]);
%! ways = diff (cell2mat (seen.values ()), 1, 2);
%! assert (abs (ways) <= 0.5*(1 + 1e-12)); assert (max (abs (ways(:,1:3))), [0.5 0.5 0.5], 1e-12);
%! assert (seen.Count <= 13); assert (residual < 1e-11);
%!test # what is stiff is moved less: along 3 N/m as by a mass of 1 + 3 s^2
%! system = struct ("q_scale", [10; 10], "stiffness", sparse ([3 0; 0 0]));
%! system.at = @(t, q, v) struct ("constraints", struct ("residual", q(1) + q(2) - 1));
%! system.matrices = @(at) deal (speye (2), sparse ([1 1]));
%! for seconds = [0 1 2]
%!   assert (project_positions (system, 0, [0; 0], seconds), [1; 1 + 3*seconds^2]/(2 + 3*seconds^2), 1e-12);
%! endfor
