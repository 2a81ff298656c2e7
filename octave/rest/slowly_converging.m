## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} slowly_converging (@var{share}, @var{what})
## A cellstr: empty, or a warning that the last doubling of base functions (see @code{at_rest}) still changed a number
## by more than a thousandth, the @var{share}; @var{what} is a text that takes it.  Inf and NaN: there was no doubling.
## @end deftypefn

function warnings = slowly_converging (share, what)
  warnings = {};
  if (share > 1e-3 && isfinite (share))
    warnings = {["base functions converge slowly, as where joints or loads act within a rod's length: their last" ...
                 " doubling changed " sprintf(what, share) "; PIECES=2, or more, makes straight rods of pieces"]};
  endif
endfunction

%!assert (slowly_converging (0.012, "a place by %.2g of its way"), ...
%!        {["base functions converge slowly, as where joints or loads act within a rod's length: their last doubling" ...
%!          " changed a place by 0.012 of its way; PIECES=2, or more, makes straight rods of pieces"]})
%!assert (cellfun (@(share) isempty (slowly_converging (share, "%g")), {1e-4, Inf, NaN}))
