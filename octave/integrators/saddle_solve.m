## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{lambda}] =} saddle_solve (@var{system}, @var{t}, @var{mass}, @var{jacobian}, @
##   @var{f}, @var{g}, @var{compliance})
## Solve mass x + jacobian' lambda = f, jacobian x - compliance lambda = g; @var{compliance} (a number a row of the
## jacobian, or 0) is that of springs, whose rows follow those of the joints.  Where that has no solution, at the time
## @var{t} (s), it is an error that names the joints whose constraints depend on each other.
##
## A sparse matrix that is singular gives finite numbers without a word; that they are none is seen by the rows of the
## jacobian, which they do not meet to 1e-8 of what these rows add up.
## @end deftypefn

function [x, lambda] = saddle_solve (system, t, mass, jacobian, f, g, compliance = 0)
  n = rows (mass);
  c = rows (jacobian);
  size_of_mass = full (sum (abs (diag (mass))))/n;  # rows of like size
  compliance = compliance.*ones (c, 1);
  ties = size_of_mass*jacobian;
  matrix = [mass, ties.'; ties, -size_of_mass^2*sparse(1:c, 1:c, compliance, c, c)];
  solution = quietly (@() matrix \ [f; size_of_mass*g]);
  x = solution(1:n);
  lambda = size_of_mass*solution(n+1:end);
  off = abs (jacobian*x - compliance.*lambda - g);
  added = abs (jacobian)*(abs (x) + abs (f)./abs (diag (mass))) + compliance.*abs (lambda) + abs (g);
  if (! all (off <= 1e-8*added))
    refuse_dependent (system, t, jacobian(! compliance,:));
    if (t > 0)
      stop_integration ("mechanism", system, t, NaN, "its equations have no unique solution", "other joints");
    endif
  endif
endfunction

%!test
%! [x, lambda] = saddle_solve (struct (), 0, sparse (diag ([1 2])), sparse ([1 1]), [3; 0], 0);
%! assert ([x; lambda], [1; -1; 2], 1e-12);
%!test # with a joint and a spring
%! [M, J, c] = deal (sparse (diag ([1 2])), sparse ([1 1; 1 -1]), [0; 0.5]);
%! [x, lambda] = saddle_solve (struct (), 0, M, J, [3; 0], [0; 1], c);
%! assert (M*x + J.'*lambda, [3; 0], 1e-12); assert (J*x - c.*lambda, [0; 1], 1e-12);
%!error <at t = 0 s 1 of 2 constraints depend on the others, those of (elbow|knee):>  # rows that contradict each other
%! mechanism.constraints.names = {"elbow", "knee"};
%! saddle_solve (struct ("mechanism", mechanism), 0, speye (2), sparse ([1 1; 1 1]), [0; 0], [1; 2]);
%!error <mechanism stopped at t = 0.5 s of 1 s: its equations have no unique solution>
%! system = struct ("duration", 1, "stiffness", 0, "mass", 1);
%! saddle_solve (system, 0.5, speye (2), sparse ([1 1]), [NaN; 0], 0);
%!test # rows that say the same twice have a solution
%! x = saddle_solve (struct (), 0, speye (2), sparse ([1 1; 1 1]), [0; 0], [1; 1]);
%! assert (x, [0.5; 0.5], 1e-7);
