## -*- texinfo -*-
## @deftypefn {} {@var{sum} =} along_markers (@var{sum}, @var{kind}, @var{gradients}, @var{rates})
## What constraints of one @var{kind} (see @code{list_constraints}) change by as their markers move: to @var{sum}
## (rows-by-k) are added the @var{gradients} (see @code{joint_constraints}) times the @var{rates} of x, y and angle (a
## cell of markers-by-k).
## @end deftypefn

function sum = along_markers (sum, kind, gradients, rates)
  for coordinate = kind.coordinates
    markers = kind.first;
    if (coordinate > 3)
      markers = kind.second;
    endif
    sum += gradients{coordinate}.*rates{mod(coordinate - 1, 3) + 1}(markers,:);
  endfor
endfunction

%!test
%! kind = struct ("coordinates", [1 6], "first", 2, "second", 1);
%! assert (along_markers (5, kind, {2, [], [], [], [], 3}, {[10; 20], [0; 0], [7; 8]}), 5 + 2*20 + 3*7);
