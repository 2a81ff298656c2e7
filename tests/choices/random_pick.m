## -*- texinfo -*-
## @deftypefn {} {@var{x} =} random_pick (@var{list})
## One of a @var{list}, numbers or a cell array, each as likely.
## @end deftypefn

function x = random_pick (list)
  x = list(ceil (rand ()*numel (list)));
  if (iscell (x))
    x = x{1};
  endif
endfunction

%!test
%! x = with_seed (1, @() arrayfun (@(k) random_pick ([5 7 9]), 1:900));
%! assert (mean (x == [5; 7; 9], 2), [1; 1; 1]/3, 0.05);
%!assert (random_pick ({"a"}), "a"); assert (random_pick (7), 7);
