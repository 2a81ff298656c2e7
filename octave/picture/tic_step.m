## -*- texinfo -*-
## @deftypefn {} {@var{step} =} tic_step (@var{range}, @var{most})
## The smallest of 1, 2, 5, 10, … (times a power of ten) that puts no more than @var{most} intervals in @var{range}.
## @end deftypefn

function step = tic_step (range, most)
  smallest = diff (range) / most;
  decade = 10 ^ floor (log10 (smallest));
  steps = decade * [1 2 5 10];
  step = steps(find (steps >= smallest * (1 - 1e-9), 1));
endfunction

%!assert (tic_step ([0 1], 5), 0.2, 1e-15)
%!assert (tic_step ([0 70], 5), 20, 1e-12)
%!assert (tic_step ([-30 330], 4), 100, 1e-12)
