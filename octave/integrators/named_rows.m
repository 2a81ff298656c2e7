## -*- texinfo -*-
## @deftypefn {} {@var{parts} =} named_rows (@var{system}, @var{states})
## The @var{states} of a mechanism (see @code{mechanism_system}), a column a time, by their names: a struct of q, v
## (n-by-m), lambda (constraints-by-m), W and D (1-by-m).
## @end deftypefn

function parts = named_rows (system, states)
  n = system.n;
  parts.q = states(1:n,:);
  parts.v = states(n+1:2*n,:);
  parts.lambda = states(2*n+1:end-2,:);
  parts.W = states(end-1,:);
  parts.D = states(end,:);
endfunction

%!assert (named_rows (struct ("n", 2), (1:9).'), struct ("q", [1; 2], "v", [3; 4], "lambda", [5; 6; 7], "W", 8, "D", 9))
