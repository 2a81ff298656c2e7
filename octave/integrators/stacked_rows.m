## -*- texinfo -*-
## @deftypefn {} {@var{states} =} stacked_rows (@var{parts})
## The states of a mechanism, a column a time, of their @var{parts} q, v, lambda, W and D (see @code{named_rows}).
## @end deftypefn

function states = stacked_rows (parts)
  states = [parts.q; parts.v; parts.lambda; parts.W; parts.D];
endfunction

%!test # there and back
%! states = reshape (1:18, 9, 2);
%! assert (stacked_rows (named_rows (struct ("n", 2), states)), states);
