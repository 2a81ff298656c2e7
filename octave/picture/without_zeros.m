## -*- texinfo -*-
## @deftypefn {} {@var{panel} =} without_zeros (@var{panel})
## A panel (see @code{new_panel}) without the curves that stay below 1e-9 of the largest value in it: rounding, which
## nobody could tell from zero. Where all are zero the first stays.
## @end deftypefn

function panel = without_zeros (panel)
  reach = max (abs (panel.values), [], 2);
  seen = reach > 1e-9*max ([reach; 0]);
  if (! any (seen) && ! isempty (seen))
    seen(1) = true;
  endif
  panel.values = panel.values(seen,:);
  panel.names = panel.names(seen);
endfunction

%!test
%! panel = without_zeros (new_panel ("energies", "J", {"T", "U", "Z"}, [1 2; 0 1e-12; -3 0]));
%! assert (panel.names, {"T", "Z"}); assert (panel.values, [1 2; -3 0]);
%!assert (without_zeros (new_panel ("energies", "J", {"T", "U"}, zeros (2, 3))).names, {"T"})
%!assert (without_zeros (new_panel ("modes", "m", {"a", "b"}, [1; 1e-8])).names, {"a", "b"})
