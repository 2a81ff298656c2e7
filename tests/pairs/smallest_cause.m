## -*- texinfo -*-
## @deftypefn {} {@var{cause} =} smallest_cause (@var{row}, @var{first}, @var{same})
## The values of a @var{row} (see @code{next_row}) that are needed for what happens there: all others may have the
## @var{first} of their factor.  @var{same} (row) tells whether the same happens.
## @end deftypefn

function cause = smallest_cause (row, first, same)
  for k = 1:numel (row)
    if (row(k) != first(k))
      other = row;
      other(k) = first(k);
      if (same (other))
        row = other;
      endif
    endif
  endfor
  cause = row(row != first);
endfunction

%!test
%! assert (smallest_cause ([2 4 6 8], [1 3 5 7], @(row) all (ismember ([4 8], row))), [4 8]);
