## -*- texinfo -*-
## @deftypefn {} {@var{warnings} =} missing_warnings (@var{missing})
## A text for each reason why files are missing, with all that it is the reason of: @var{missing} (n-by-2 cellstr) has
## a file and its reason in a row.
## @end deftypefn

function warnings = missing_warnings (missing)
  warnings = {};
  for reason = unique (missing(:,2), "stable")(:).'
    names = missing(strcmp (missing(:,2), reason{1}),1);
    verb = "are";
    if (numel (names) == 1)
      verb = "is";
    endif
    warnings{end+1} = sprintf ("%s %s missing: %s", strjoin (names, ", "), verb, reason{1});
  endfor
endfunction

%!assert (missing_warnings (cell (0, 2)), {})
%!assert (missing_warnings ({"frames", "no gnuplot"; "c.gif", "no ffmpeg"; "b.svg", "no gnuplot"}), ...
%!        {"frames, b.svg are missing: no gnuplot", "c.gif is missing: no ffmpeg"})
