## -*- texinfo -*-
## @deftypefn {} {@var{states} =} first_states (@var{system}, @var{times}, @var{start})
## Room for a mechanism's states at the @var{times}: a struct of q, v (n-by-m), lambda (constraints-by-m), W,
## D (1-by-m), with @var{start} in the first column.
## @end deftypefn

function states = first_states (system, times, start)
  m = numel (times);
  states = struct ("q", zeros (system.n, m), "v", zeros (system.n, m), ...
                   "lambda", zeros (system.constraint_count, m), "W", zeros (1, m), "D", zeros (1, m));
  states = keep (states, 1, setfield (start, "lambda", zeros (system.constraint_count, 1)));
endfunction

%!assert (first_states (struct ("n", 2, "constraint_count", 1), 1:3, ...
%!                      struct ("q", [1; 2], "v", [3; 4], "W", 5, "D", 6)).q(:,1), [1; 2])
