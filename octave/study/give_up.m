## -*- texinfo -*-
## @deftypefn {} {@var{value} =} give_up (@var{value}, @var{clock}, @var{seconds})
## Let a @var{value} pass until so many @var{seconds} have gone since the @var{clock} (a tic): then it is an error of
## an integration that takes too long for a study.
## @end deftypefn

function value = give_up (value, clock, seconds)
  taken = toc (clock);
  if (taken > seconds)
    error ("toolchain:integration", "given up after %.0f s\n", taken);
  endif
endfunction

%!assert (give_up (3, tic (), 10), 3)
%!error <given up after 0 s> give_up (3, tic (), -1)
