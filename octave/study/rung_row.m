## -*- texinfo -*-
## @deftypefn {} {@var{row} =} rung_row (@var{ladder}, @var{rung}, @var{count}, @var{error_m}, @var{chosen})
## A row of the table of @code{model_ladder}, which is printed: the @var{rung} of a @var{ladder} (see @code{ladder_of})
## that took what the @var{count} of @code{integrate} says and is off by @var{error_m} (m), where @var{chosen} is the
## rung that is taken.
## @end deftypefn

function row = rung_row (ladder, rung, count, error_m, chosen)
  row = struct ("model", ladder.name (rung), "method", count.method, "error_m", error_m, "seconds", count.seconds, ...
                "calls", count.calls, "label", ladder.label (rung), "curve", ladder.curve (rung), ...
                "chosen", isequal (rung, chosen), "part", 1);
  mark = "";
  if (row.chosen)
    mark = " <-";
  endif
  say ("  %-62s %-11s %8.2g m %8.2f s %8d calls%s", row.model, row.method, row.error_m, row.seconds, ...
       row.calls, mark);
  fflush (stdout);
endfunction

%!test
%! ladder = struct ("name", @(rung) "one", "label", @(rung) "1", "curve", @(rung) "rungs");
%! count = struct ("method", "rk4", "seconds", 2, "calls", 8);
%! said = evalc ("row = rung_row (ladder, 3, count, 1e-3, 3);");
%! assert (row.chosen && strcmp (row.curve, "rungs")); assert (said(end-3:end), " <-\n");
%! assert ({row.model, row.method, row.error_m, row.seconds, row.calls, row.label}, {"one", "rk4", 1e-3, 2, 8, "1"});
%! assert (row.part, 1);
%! assert (regexp (said, '^  one +rk4 +0.001 m +2.00 s +8 calls <-\n$'), 1);
%! said = evalc ("row = rung_row (ladder, 3, count, 1e-3, 4);");
%! assert (! row.chosen); assert (said(end-5:end), "calls\n");
