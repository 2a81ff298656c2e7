## -*- texinfo -*-
## @deftypefn {} {@var{limit} =} real_limit (@var{method})
## The largest step times rate of decay for which an explicit @var{method} stays stable: where its stability function
## is 1 on the negative real axis.
## @end deftypefn

function limit = real_limit (method)
  R = stability_function (method);
  limit = fzero (@(x) abs (polyval (R, -x)) - 1, [1, 10]);
endfunction

%!assert (real_limit ("rk4"), 2.785293563, 1e-8)  # Hairer and Wanner, Solving Ordinary Differential Equations II
