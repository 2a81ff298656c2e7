## -*- texinfo -*-
## @deftypefn {} {@var{rows} =} fastest_rows (@var{table}, @var{tolerance})
## Of each method in the @var{table} of @code{work_precision} the row of the fewest seconds that is within the
## @var{tolerance} (m), of those that have one.
## @end deftypefn

function rows = fastest_rows (table, tolerance)
  near = table(cellfun (@isempty, {table.failure}) & [table.error_m] <= tolerance);
  rows = near([]);
  for name = unique ({near.method}, "stable")
    of_method = near(strcmp ({near.method}, name{1}));
    [~, k] = min ([of_method.seconds]);
    rows(end+1) = of_method(k);
  endfor
endfunction

%!test # what fails or is too far has none
%! table = struct ("method", {"a" "a" "a" "b" "c"}, "error_m", {1e-2 1e-4 1e-6 NaN 1}, "seconds", {1 2 3 1 1}, ...
%!                 "failure", {"" "" "" "it failed" ""});
%! assert (fastest_rows (table, 1e-3), table(2));
%! assert (isempty (fastest_rows (table, 1e-9)));
