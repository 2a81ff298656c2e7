## -*- texinfo -*-
## @deftypefn {} {} announce_levels (@var{choice})
## Say which levels of the bodies' models were tried, what each was off by and cost (see @code{choose_mechanism}).
## @end deftypefn

function announce_levels (choice)
  for tried = choice.tried
    levels = sprintf ("%d ", tried.levels);
    if (numel (levels) > 40)
      levels = sprintf ("%d to %d ", min (tried.levels), max (tried.levels));
    endif
    taken = isequal ({tried.levels, tried.longitudinal}, {choice.levels, choice.longitudinal});
    say ("  bending modes %-34s%-8s %8.2g m %6.2f s%s", levels, "and axial"(1:end*any (tried.longitudinal)), ...
         tried.error_m, tried.seconds, repmat (" <-", 1, taken));
  endfor
endfunction

%!test
%! tried = struct ("levels", [1 2], "longitudinal", [0 0], "error_m", 1e-5, "seconds", 0.5);
%! text = evalc ("announce_levels (struct (\"tried\", tried, \"levels\", [1 2], \"longitudinal\", [0 0]))");
%! assert (! isempty (regexp (text, "bending modes 1 2 .*1e-05 m   0.50 s <-")));
