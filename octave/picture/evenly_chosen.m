## -*- texinfo -*-
## @deftypefn {} {@var{index} =} evenly_chosen (@var{n}, @var{most})
## At most so many of @var{n} things, evenly, with the first and the last among them (a row of indices).
## @end deftypefn

function index = evenly_chosen (n, most)
  index = unique (round (linspace (1, n, most)));
endfunction

%!assert (evenly_chosen (11, 3), [1 6 11])
%!assert (evenly_chosen (4, 400), 1:4)
%!assert (evenly_chosen (1, 6), 1)
