## -*- texinfo -*-
## @deftypefn {} {@var{yes} =} clearly_fewer (@var{n}, @var{reference})
## Whether numbers @var{n} of base functions are so much below those of a @var{reference} that its distance tells their
## error: each at least two below it, and at most 80 % of it and one more; none are always fewer.
## @end deftypefn

function yes = clearly_fewer (n, reference)
  yes = all (n == 0 | n <= min (0.8*reference + 1, reference - 2));
endfunction

%!assert (clearly_fewer ([0 25], [0 30]))
%!assert (! clearly_fewer ([0 26], [0 30]))
%!assert (clearly_fewer (2, 4)); assert (! clearly_fewer (3, 4))
%!assert (! clearly_fewer ([1 2], [1 14]))
