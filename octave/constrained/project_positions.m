## -*- texinfo -*-
## @deftypefn {} {[@var{q}, @var{residual}] =} project_positions (@var{system}, @var{t}, @var{q})
## The coordinates nearest to @var{q} (n-by-1), in the mass metric, that meet the constraints at the time @var{t} (s), by
## Newton's iteration, and the largest @var{residual} left.
## @end deftypefn

function [q, residual] = project_positions (system, t, q)
  given = q;
  residual = Inf;
  for iteration = 1:50
    at = system.at (t, q, 0*q);
    [mass, jacobian] = system.matrices (at);
    last = residual;
    residual = max ([abs(at.constraints.residual); 0]);
    if (residual < 1e-14 || (residual < 1e-11 && residual > last/4))
      return;
    endif
    step = saddle_solve (system, 0, mass, jacobian, mass*(given - q), -at.constraints.residual);
    largest = max (abs (step)./system.q_scale);
    q += step*min (1, 0.5/largest);  # half a metre, half a radian on a rod of a metre
  endfor
endfunction
