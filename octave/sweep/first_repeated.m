## -*- texinfo -*-
## @deftypefn {} {[@var{again}, @var{before}] =} first_repeated (@var{texts})
## The number of the first of the @var{texts} (cellstr) that stands there @var{before}, and where; [] of none.
## @end deftypefn

function [again, before] = first_repeated (texts)
  [~, first] = unique (texts, "first");
  again = setdiff (1:numel (texts), first)(1:min (end, 1));
  before = [];
  if (! isempty (again))
    before = find (strcmp (texts, texts{again}), 1);
  endif
endfunction

%!assert (nthargout (1:2, @first_repeated, {"a", "b", "c", "b", "a"}), {4, 2})
%!assert (cellfun (@isempty, nthargout (1:2, @first_repeated, {"a"; "b"})), [true true])
