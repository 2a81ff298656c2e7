## -*- texinfo -*-
## @deftypefn {} {@var{index} =} equally_spaced (@var{n}, @var{most})
## At most so many, and half as many at least, of @var{n} things, with equal steps between them from the first to the
## last (a row of indices); where there are no such steps, nearly so (see @code{evenly_chosen}).
## @end deftypefn

function index = equally_spaced (n, most)
  steps = most - 1:-1:ceil (most/2) - 1;
  equal = steps(mod (n - 1, steps) == 0);
  if (n > most && ! isempty (equal))
    index = linspace (1, n, equal(1) + 1);
  else
    index = evenly_chosen (n, most);
  endif
endfunction

%!assert (equally_spaced (91, 13), 1:9:91)  # not 1, 9, 16, 24, ...
%!assert (equally_spaced (101, 9), 1:20:101)
%!assert (equally_spaced (102, 9), evenly_chosen (102, 9))
%!assert (equally_spaced (3, 9), 1:3)
%!assert (equally_spaced (1, 13), 1)
