## -*- texinfo -*-
## @deftypefn {} {[@var{x}, @var{lambda}] =} saddle_solve (@var{system}, @var{t}, @var{mass}, @var{jacobian}, @
##   @var{f}, @var{g}, @var{compliance})
## Solve mass x + jacobian' lambda = f, jacobian x - compliance lambda = g; @var{compliance} (a number a row of the
## jacobian, or 0) is that of springs, whose rows follow those of the joints.  Where that has no unique solution, at
## the time @var{t} (s), it is an error that names the joints whose constraints depend on each other.
## @end deftypefn

function [x, lambda] = saddle_solve (system, t, mass, jacobian, f, g, compliance = 0)
  n = rows (mass);
  c = rows (jacobian);
  size_of_mass = mean (abs (diag (mass)));  # rows of like size
  compliance = compliance.*ones (c, 1);
  matrix = [mass, size_of_mass*jacobian.'; size_of_mass*jacobian, -size_of_mass^2*spdiags(compliance, 0, c, c)];
  warning_state = warning ("off", "all");
  unwind_protect
    lastwarn ("");
    solution = matrix \ [f; size_of_mass*g];
    warned = lastwarn ();
  unwind_protect_cleanup
    warning (warning_state);
  end_unwind_protect
  if (! isempty (warned) || ! all (isfinite (solution)))
    refuse_dependent (system, t, jacobian(! compliance,:));
  endif
  x = solution(1:n);
  lambda = size_of_mass*solution(n+1:end);
endfunction

%!test
%! [x, lambda] = saddle_solve (struct (), 0, sparse (diag ([1 2])), sparse ([1 1]), [3; 0], 0);
%! assert ([x; lambda], [1; -1; 2], 1e-12);
%!test # with a joint and a spring
%! [M, J, c] = deal (sparse (diag ([1 2])), sparse ([1 1; 1 -1]), [0; 0.5]);
%! [x, lambda] = saddle_solve (struct (), 0, M, J, [3; 0], [0; 1], c);
%! assert (M*x + J.'*lambda, [3; 0], 1e-12); assert (J*x - c.*lambda, [0; 1], 1e-12);
