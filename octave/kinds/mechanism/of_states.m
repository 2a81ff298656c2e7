## -*- texinfo -*-
## @deftypefn {} {@var{indices} =} of_states (@var{index}, @var{n}, @var{states})
## Where the rows @var{index} (r-by-b) of an @var{n}-by-@var{states} array are in its columns one below the other:
## r-by-(b states).
## @end deftypefn

function indices = of_states (index, n, states)
  indices = reshape (index(:) + n*(0:states-1), rows (index), []);
endfunction

%!test
%! x = reshape (1:12, 4, 3);
%! assert (x(:)(of_states ([1; 4], 4, 3)), x([1 4],:));
%! assert (of_states ([1 3; 2 4], 4, 2), [1 3 5 7; 2 4 6 8]);
