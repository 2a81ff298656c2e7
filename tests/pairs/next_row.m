## -*- texinfo -*-
## @deftypefn {} {@var{row} =} next_row (@var{open}, @var{factor_of}, @var{refused})
## A value of each factor, with a pair that is still @var{open} and as many others as a greedy choice finds.  Values
## are numbers 1 to n: @var{open} (n-by-n, symmetric, logical) has the pairs, @var{factor_of} (1-by-n) whose value each
## is, and @var{row} holds none of the sets in @var{refused} (a cell array of vectors), where that can be.
## @end deftypefn

function row = next_row (open, factor_of, refused)
  [i, j] = find (open, 1);
  chosen = [i, j];
  others = setdiff (1:max (factor_of), factor_of(chosen));
  for factor = others(randperm (numel (others)))
    values = find (factor_of == factor);
    allowed = values(! arrayfun (@(value) holds_any ([chosen, value], refused), values));
    if (isempty (allowed))
      allowed = values(1);
    endif
    [~, best] = max (sum (open(allowed,chosen), 2));
    chosen(end+1) = allowed(best);
  endfor
  row = sort (chosen);
endfunction

function yes = holds_any (chosen, sets)
  yes = any (cellfun (@(set) all (ismember (set, chosen)), sets));
endfunction

%!test # three factors of three values: nine rows at least, and not many more
%! factor_of = [1 1 1 2 2 2 3 3 3];
%! open = factor_of != factor_of.';
%! for rows = 1:15
%!   row = next_row (open, factor_of, {});
%!   assert (factor_of(row), 1:3);
%!   open(row,row) = false;
%!   if (! any (open(:)))
%!     break;
%!   endif
%! endfor
%! assert (! any (open(:))); assert (rows >= 9);
%!test # what is refused is left out
%! factor_of = [1 1 2 2 3 3];
%! open = false (6);
%! open(1,3) = open(3,1) = true;
%! assert (next_row (open, factor_of, {[1 5]}), [1 3 6]);
